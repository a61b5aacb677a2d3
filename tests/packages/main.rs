mod dependency;
mod examples;
mod pages;
