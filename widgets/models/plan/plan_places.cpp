#include "widgets/models/plan/plan_places.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/agent/posh/posh_binding.h"

namespace usar::widgets {

namespace {

/// Returns the size of the code point at `position` in bytes of UTF-8 and in units of UTF-16.
std::pair<int, int> sizesAt(const QString& line, int position) {
    const bool two =
        line[position].isHighSurrogate() && position + 1 < line.size() && line[position + 1].isLowSurrogate();
    const char16_t unit = line[position].unicode();
    return {two ? 4 : unit < 0x80 ? 1 : unit < 0x800 ? 2 : 3, two ? 2 : 1};
}

} // namespace

QString editorText(std::string_view plan_text) {
    QString text = QString::fromUtf8(plan_text);
    text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
    for (QChar& c : text)
        if (c == u'\r' || c == QChar::LineSeparator || c == QChar::ParagraphSeparator)
            c = u' ';
    return text;
}

TextRange rangeOf(const posh::Spot& spot, const QString& line) {
    const int end = static_cast<int>(line.size());
    int start = 0;
    for (std::uint32_t column = 1; column < spot.column && start < end; ++column)
        start += sizesAt(line, start).second;
    int length = 0;
    for (int bytes = 0; bytes < static_cast<int>(spot.length) && start + length < end;) {
        const auto [in_utf8, units] = sizesAt(line, start + length);
        bytes += in_utf8;
        length += units;
    }
    if (start >= end) // After the last character: mark that one.
        return {std::max(0, end - 1), std::min(1, end)};
    return {start, std::max(1, length)};
}

int columnOf(const QString& line, int position) {
    int column = 1;
    for (int at = 0; at < std::min(position, static_cast<int>(line.size())); ++column)
        at += sizesAt(line, at).second;
    return column;
}

PlanNodeId nodeAtPlace(const PlanTree& tree, int line, int column) {
    const auto placeOf = [&tree](PlanNodeId node) { return std::pair(tree[node].at.line, tree[node].at.column); };
    const std::pair place(static_cast<std::uint32_t>(std::max(0, line)),
                          static_cast<std::uint32_t>(std::max(0, column)));
    PlanNodeId found;
    for (const PlanNodeId node : tree.nodes())
        if (tree[node].at.line > 0 && placeOf(node) <= place && !tree[node].link.valid() &&
            (!found.valid() || placeOf(node) > placeOf(found)))
            found = node;
    return found;
}

std::vector<PlanNote> notesOf(const posh::Plan& plan) {
    const std::string remark = agent::clockRemark(plan);
    if (remark.empty())
        return {};
    const posh::Collection& collection = *posh::collectionOf(plan);
    posh::Spot at = collection.at;
    at.length = static_cast<std::uint32_t>(1 + collection.keyword.size()); // Only "(RDC", not the whole collection.
    return {
        {at, QStringLiteral("%1:%2: note N501: %3").arg(at.line).arg(at.column).arg(QString::fromStdString(remark))}};
}

} // namespace usar::widgets
