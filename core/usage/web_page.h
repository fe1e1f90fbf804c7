// Pages for a browser, from what a Markdown reader made of our pages: headings can be linked to, and links lead to the
// pages that were made, not to their sources.
#pragma once

#include <QString>

namespace usar::usage {

/// The anchor of a heading with this text, as GitHub makes it: "What it does" is reached by `#what-it-does`.
QString anchorOf(const QString& heading);

/// A whole page from the body that cmark-gfm writes. Headings get their anchors, those that occur again with -1, -2 and
/// so on; local links to pages (.md) lead to .html. `root` is the way from the page to the folder that has page.css
/// and README.html: empty, or "../../". The title is that of the first heading.
QString webPage(const QString& body, const QString& root);

} // namespace usar::usage
