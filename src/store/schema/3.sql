-- Addresses of people, and links to sign in that were sent to them.
CREATE TABLE mail_address (person TEXT PRIMARY KEY, address TEXT NOT NULL);
CREATE INDEX mail_address_address ON mail_address (address);
CREATE TABLE mailed_link (hash TEXT PRIMARY KEY, person TEXT NOT NULL, address TEXT NOT NULL, expires BIGINT NOT NULL);
CREATE INDEX mailed_link_person ON mailed_link (person);
