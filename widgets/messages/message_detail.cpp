#include "widgets/messages/message_detail.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "widgets/models/figures.h"
#include "widgets/models/messages/message_parts.h"
#include "widgets/models/messages/notification_model.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr std::size_t longest_text = 4000; ///< limit for the text of a line, in bytes
constexpr std::size_t most_rows = 200;     ///< limit for the rows of a table
constexpr int pointer_width = 48;

QString html(std::string_view text) {
    return QString::fromUtf8(text).toHtmlEscaped();
}

QString link(std::uint64_t serial, const QString& text) {
    return QStringLiteral("<a href=\"row:%1\">%2</a>").arg(serial).arg(text.toHtmlEscaped());
}

QString tableRow(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td style=\"color:%1; padding-right:12px\">%2</td><td>%3</td></tr>")
        .arg(tokens().text_muted.name(), name, value);
}

/// Makes a table of the first rows, which `row_of` makes; a last row says how many more there are.
template <class Entries, class RowOf>
QString tableOf(const Entries& entries, RowOf row_of) {
    if (entries.empty())
        return {};
    QString rows;
    for (const auto& entry : std::span(entries).first(std::min(entries.size(), most_rows)))
        rows += row_of(entry);
    if (entries.size() > most_rows)
        rows += tableRow(QStringLiteral("…"),
                         MessageDetail::tr("%n more", nullptr, static_cast<int>(entries.size() - most_rows)));
    return QStringLiteral("<table cellspacing=\"0\">%1</table>").arg(rows);
}

QString troubles(const MessageRow& row, const Diagnostics& diagnostics) {
    QString text;
    for (const Diagnostic& diagnostic : diagnostics) {
        const QColor ink = severityColor(diagnostic.severity);
        const Pointer pointer = pointerAt(row.text, diagnostic.offset, pointer_width);
        text += QStringLiteral("<pre style=\"margin:4px 0 0 0\">%1\n<span style=\"color:%2\">%3</span></pre>"
                               "<p style=\"margin:0 0 4px 0; color:%2\">%4</p>")
                    .arg(pointer.excerpt.toHtmlEscaped(), ink.name(), pointer.caret,
                         MessageDetail::tr("Column %1: %2").arg(diagnostic.offset + 1).arg(html(diagnostic.message)));
    }
    return text;
}

QString fieldRow(const protocol::Field& field) {
    const QString name = field.item.empty() ? html(field.field) : html(field.item) + u' ' + html(field.field);
    return tableRow(name, valueText(field).toHtmlEscaped());
}

QString segmentRow(const MessagePart& part) {
    const QString value = html(std::string_view(part.value).substr(0, longest_text / 10));
    return tableRow(html(part.key), part.help.empty() ? value
                                                      : QStringLiteral("%1 <span style=\"color:%2\">· %3</span>")
                                                            .arg(value, tokens().text_muted.name(), html(part.help)));
}

} // namespace

MessageDetail::MessageDetail(QWidget* parent) : QTextBrowser(parent) {
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(tr("Selected line"));
    document()->setDocumentMargin(gap::small);
    connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
        if (url.scheme() == u"row")
            emit jumpRequested(url.path().toULongLong());
    });
    clearRow();
    onThemeChange(this, [this] { render(); });
}

void MessageDetail::show(const MessageModel& model, std::uint64_t serial) {
    const MessageRow* row = model.find(serial);
    if (!row)
        return;
    row_ = *row;
    head_ = headOf(model, *row) + causeOf(model, *row, serial);
    render();
}

void MessageDetail::clearRow() {
    row_.reset();
    head_ = tr("<p>Select a line: its values, what is wrong with it, and why it was sent appear here.</p>");
    render();
}

QString MessageDetail::headOf(const MessageModel& model, const MessageRow& row) const {
    if (row.not_shown > 0)
        return QStringLiteral("<p><b>%1</b></p><p>%2</p>").arg(html(row.text), html(row.note));
    QStringList words{tr("No. %1").arg(row.number), row.direction == Direction::In ? tr("in") : tr("out")};
    if (const QString robot = model.connectionName(row.connection); !robot.isEmpty())
        words << robot.toHtmlEscaped();
    if (std::isfinite(row.time.count()))
        words << figure(row.time.count(), 2) + tr(" s");
    return QStringLiteral("<p style=\"margin:0\"><b>%1</b> · %2</p>")
        .arg(html(row.type), words.join(QStringLiteral(" · ")));
}

QString MessageDetail::causeOf(const MessageModel& model, const MessageRow& row, std::uint64_t serial) const {
    QStringList sentences;
    if (row.direction == Direction::Out && !row.note.empty())
        sentences << sourceOf(model, row);
    QStringList caused;
    for (const std::uint64_t other : model.causedBy(serial))
        caused << link(
            other,
            tr("%1 (No. %2)").arg(QString::fromStdString(model.find(other)->type)).arg(model.find(other)->number));
    if (!caused.isEmpty())
        sentences << tr("It made us send %1.").arg(caused.join(QStringLiteral(", ")));
    return sentences.isEmpty() ? QString()
                               : QStringLiteral("<p style=\"margin:4px 0 0 0\">%1</p>").arg(sentences.join(u' '));
}

QString MessageDetail::sourceOf(const MessageModel& model, const MessageRow& row) const {
    const QString source = html(std::string_view(row.note).substr(0, row.note.rfind(", on line ")));
    if (row.trigger == 0)
        return tr("Sent by %1.").arg(source);
    const auto serial = model.serialOf(row.connection, Direction::In, row.trigger);
    const MessageRow* cause = serial ? model.find(*serial) : nullptr;
    if (!cause)
        return tr("Sent by %1, on line %2, which is no longer in the list.").arg(source).arg(row.trigger);
    const QString words = tr("line %1 (%2)").arg(row.trigger).arg(QString::fromStdString(cause->type));
    return tr("Sent by %1, on %2.").arg(source, link(serial.value_or(0), words));
}

QString MessageDetail::bodyOf(const MessageRow& row) const {
    if (row.not_shown > 0)
        return {};
    const MessageParts parts = partsOf(row);
    QString text = html(std::string_view(row.text).substr(0, longest_text));
    if (row.text.size() > longest_text)
        text += tr(" … (%1 bytes)").arg(row.text.size());
    const QString heading = QStringLiteral("<p style=\"margin:8px 0 0 0; color:%1\">%2</p>");
    const QString muted = tokens().text_muted.name();
    QString body =
        QStringLiteral("<p style=\"margin:8px 0 0 0; font-family:'%1'\">%2</p>").arg(codeFont().family(), text);
    body += troubles(row, parts.diagnostics);
    if (const QString fields = tableOf(parts.fields, fieldRow); !fields.isEmpty())
        body += heading.arg(muted, parts.known ? tr("Values, in SI units and map axes")
                                               : tr("Values as on the wire: no table knows this type")) +
                fields;
    if (const QString segments = tableOf(parts.segments, segmentRow); !segments.isEmpty())
        body += heading.arg(muted, tr("Segments as on the wire")) + segments;
    return body;
}

} // namespace usar::widgets
