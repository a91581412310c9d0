//! Writing links: a line each.

use super::write::List;
use crate::target::Output;
use crate::{Error, Links};

/// Writes lines from where links begin to where they end, with numbers and length as properties.
pub(crate) fn write_links(out: &mut Output<'_>, links: &Links<'_>) -> Result<(), Error> {
    let [from, to, length] = links
        .names
        .map(|name| serde_json::Value::from(name).to_string());
    let mut list = List::begin(out)?;
    for link in links.links {
        let [a, b] = links.numbers(link);
        list.next(|out| {
            out.text(format_args!("{{{from}:{a},{to}:{b},{length}:"))?;
            match link.length.is_finite() {
                true => out.number(link.length),
                false => out.bytes(b"null")?,
            }
            out.bytes(b"},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[")?;
            for (i, p) in [links.from[link.from], links.ends()[link.to]]
                .into_iter()
                .enumerate()
            {
                out.bytes(if i == 0 { b"[" } else { b",[" })?;
                out.number(p.x);
                out.separator(b',');
                out.number(p.y);
                out.bytes(b"]")?;
            }
            out.bytes(b"]}")
        })?;
    }
    list.end()
}
