#include "widgets/models/messages/line_history.h"

namespace usar::widgets {

void LineHistory::setLines(const QStringList& lines) {
    lines_ = lines.mid(std::max<qsizetype>(0, lines.size() - limit));
    endWalk();
}

void LineHistory::add(const QString& line) {
    lines_.removeAll(line);
    lines_ << line;
    if (lines_.size() > limit)
        lines_.removeFirst();
    endWalk();
}

bool LineHistory::fits(qsizetype at) const {
    return lines_[at].contains(typed_, Qt::CaseInsensitive);
}

std::optional<QString> LineHistory::older(const QString& typed) {
    if (!at_)
        typed_ = typed;
    for (qsizetype at = at_.value_or(lines_.size()) - 1; at >= 0; --at)
        if (fits(at)) {
            at_ = at;
            return lines_[at];
        }
    return std::nullopt;
}

std::optional<QString> LineHistory::newer() {
    if (!at_)
        return std::nullopt;
    for (qsizetype at = *at_ + 1; at < lines_.size(); ++at)
        if (fits(at)) {
            at_ = at;
            return lines_[at];
        }
    endWalk();
    return typed_;
}

} // namespace usar::widgets
