mod dependency;
mod examples;
mod modules;
mod pages;
