// Writes the elements of an HTML page; everything is escaped by the XML writer.
#pragma once

#include <functional>

#include <QStringList>
#include <QXmlStreamWriter>

namespace usar::campaign {

/// An element from its construction to its destruction, for what has more in it than words.
class HtmlElement {
public:
    HtmlElement(QXmlStreamWriter& xml, const QString& name, const QString& style_class = {}) : xml_(xml) {
        xml_.writeStartElement(name);
        if (!style_class.isEmpty())
            xml_.writeAttribute("class", style_class);
        xml_.writeCharacters(""); // Without it an empty element would close itself, which HTML does not know.
    }
    ~HtmlElement() { xml_.writeEndElement(); }
    HtmlElement(const HtmlElement&) = delete;
    HtmlElement& operator=(const HtmlElement&) = delete;

private:
    QXmlStreamWriter& xml_;
};

/// An element with words in it.
inline void write(QXmlStreamWriter& xml, const QString& name, const QString& words, const QString& style_class = {}) {
    const HtmlElement element(xml, name, style_class);
    xml.writeCharacters(words);
}

/// The first row of a table.
inline void writeHead(QXmlStreamWriter& xml, const QStringList& titles) {
    const HtmlElement head(xml, "thead");
    const HtmlElement row(xml, "tr");
    for (const QString& title : titles)
        write(xml, "th", title);
}

} // namespace usar::campaign
