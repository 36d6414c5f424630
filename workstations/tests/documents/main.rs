//! Documents of several pages, looked at from outside: by their structure and by other programs.

mod card;
mod long_line;
mod pdf;
mod postscript;
mod programs;
mod receiver;
