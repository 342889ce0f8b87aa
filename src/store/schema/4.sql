-- How often something was done lately, by a hash of what is counted: after `free_at` nothing counts any more.
CREATE TABLE allowance (key TEXT PRIMARY KEY, free_at BIGINT NOT NULL);
CREATE INDEX allowance_free_at ON allowance (free_at);
