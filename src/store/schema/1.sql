-- `data` is the record as JSON; the columns beside it are those by which it is found, or which must be unique.
CREATE TABLE person (key TEXT PRIMARY KEY, login TEXT UNIQUE, data TEXT NOT NULL);
CREATE TABLE password (person TEXT PRIMARY KEY, hash TEXT NOT NULL);
CREATE TABLE ticket (hash TEXT PRIMARY KEY, person TEXT NOT NULL, kind TEXT NOT NULL, expires BIGINT NOT NULL);
CREATE INDEX ticket_person ON ticket (person);

CREATE TABLE course (key TEXT PRIMARY KEY, secret TEXT NOT NULL, data TEXT NOT NULL);
CREATE TABLE member (key TEXT PRIMARY KEY, course TEXT NOT NULL, person TEXT NOT NULL, data TEXT NOT NULL, UNIQUE (course, person));
CREATE INDEX member_person ON member (person);

CREATE TABLE problem_file (course TEXT NOT NULL, digest TEXT NOT NULL, problem TEXT NOT NULL, data TEXT NOT NULL, PRIMARY KEY (course, digest));

-- `closes` is the latest close of any student, extensions included; `revision` grows with every change of the assignment, its items
-- and extensions, so that nothing is handed in by rules that no longer hold.
CREATE TABLE assignment (key TEXT PRIMARY KEY, course TEXT NOT NULL, opens BIGINT NOT NULL, closes BIGINT NOT NULL, revision BIGINT NOT NULL, data TEXT NOT NULL);
CREATE INDEX assignment_course ON assignment (course);
CREATE TABLE item (key TEXT PRIMARY KEY, assignment TEXT NOT NULL, problem TEXT NOT NULL, data TEXT NOT NULL);
CREATE INDEX item_problem ON item (problem);
CREATE INDEX item_assignment ON item (assignment);
CREATE TABLE extension (assignment TEXT NOT NULL, member TEXT NOT NULL, closes BIGINT NOT NULL, data TEXT NOT NULL, PRIMARY KEY (assignment, member));

CREATE TABLE sheet (key TEXT PRIMARY KEY, item TEXT NOT NULL, member TEXT NOT NULL, issue BIGINT NOT NULL, data TEXT NOT NULL, UNIQUE (item, member, issue));
CREATE INDEX sheet_member ON sheet (member);
CREATE TABLE attempt (sheet TEXT NOT NULL, number BIGINT NOT NULL, request TEXT NOT NULL, data TEXT NOT NULL, PRIMARY KEY (sheet, number), UNIQUE (sheet, request));
-- Attempts as they were marked before a corrected problem was taken in.
CREATE TABLE marked_before (sheet TEXT NOT NULL, number BIGINT NOT NULL, correction TEXT NOT NULL, data TEXT NOT NULL, PRIMARY KEY (sheet, number, correction));
CREATE TABLE hint (sheet TEXT NOT NULL, part TEXT NOT NULL, number BIGINT NOT NULL, data TEXT NOT NULL, PRIMARY KEY (sheet, part, number));
CREATE TABLE draft (sheet TEXT PRIMARY KEY, data TEXT NOT NULL);

CREATE TABLE decision (key TEXT PRIMARY KEY, sheet TEXT, item TEXT, at BIGINT NOT NULL, data TEXT NOT NULL);
CREATE INDEX decision_sheet ON decision (sheet);
CREATE INDEX decision_item ON decision (item);
CREATE TABLE trail (key TEXT PRIMARY KEY, course TEXT, at BIGINT NOT NULL, data TEXT NOT NULL);
CREATE INDEX trail_course ON trail (course, at);
