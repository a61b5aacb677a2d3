//! Dependents of the library, the examples, and the pages.

mod dependency;
mod examples;
mod pages;
