-- Codes with which people ask for a place in a course, and who has asked.
CREATE TABLE course_code (course TEXT PRIMARY KEY, code TEXT NOT NULL UNIQUE, expires BIGINT NOT NULL, data TEXT NOT NULL);
CREATE TABLE place_request (key TEXT PRIMARY KEY, course TEXT NOT NULL, at BIGINT NOT NULL, data TEXT NOT NULL);
CREATE INDEX place_request_course ON place_request (course);
