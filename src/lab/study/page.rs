//! A page for a browser, complete in one file.

use base64::{Engine, prelude::BASE64_STANDARD};
use pulldown_cmark::{Options, Parser, html};
use pulldown_cmark_escape::escape_html;

/// How it looks: a column of text, plots as wide, and tables, of which the widest, that of `bench`, takes a window of 1200 pixels; in
/// narrower ones they scroll. It is light and dark as the reader's system is; plots and pictures have white grounds of their own.
const STYLE: &str = "\
:root { color-scheme: light dark; }
body { max-width: 75rem; margin: 2rem auto; padding: 0 1rem; font: 16px/1.5 system-ui, sans-serif; }
h2 { margin-top: 3rem; }
pre { white-space: pre-wrap; padding: 0.6rem 0.8rem; background: #8882; border-radius: 4px; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 12px; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.3rem; border-bottom: 1px solid #8886; }
th { vertical-align: bottom; }
td { white-space: nowrap; }
p, pre, figure { max-width: 62rem; }
figure { margin: 1.5rem 0; }
figure svg, figure img { display: block; max-width: 100%; height: auto; background: white; }
figcaption { font-size: 14px; opacity: 0.8; }";

/// The text of a page of a title and a body.
pub fn page(title: &str, body: &str) -> String {
    let title = escaped(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n\
         <style>\n{STYLE}\n</style>\n</head>\n<body>\n<h1>{title}</h1>\n{body}</body>\n</html>\n"
    )
}

/// Tables and what stands between them, from Markdown.
pub fn table(markdown: &str) -> String {
    let mut shown = String::new();
    html::push_html(
        &mut shown,
        Parser::new_ext(markdown, Options::ENABLE_TABLES),
    );
    format!("<div class=\"scroll\">\n{shown}</div>\n")
}

/// A plot or a picture by the bytes of its file, whose name ends in `.svg` or `.png`, and what it shows.
pub fn figure(name: &str, bytes: &[u8], says: &str) -> String {
    let says = escaped(says);
    let shown = if name.ends_with(".svg") {
        let text = String::from_utf8_lossy(bytes);
        // What stands before the drawing is for files of their own.
        let start = text.find("<svg").unwrap_or(0);
        text[start..].to_owned()
    } else {
        let data = BASE64_STANDARD.encode(bytes);
        format!("<img alt=\"{says}\" src=\"data:image/png;base64,{data}\">")
    };
    format!("<figure>{shown}<figcaption>{says}</figcaption></figure>\n")
}

/// Text with the marks of HTML spelt out.
pub fn escaped(text: &str) -> String {
    let mut to = String::new();
    // Writing to a string does not fail.
    let _ = escape_html(&mut to, text);
    to
}
