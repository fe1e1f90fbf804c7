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

bool LineHistory::walk(qsizetype step) {
    for (qsizetype at = at_.value_or(lines_.size()) + step; at >= 0 && at < lines_.size(); at += step)
        if (lines_[at].contains(typed_, Qt::CaseInsensitive)) {
            at_ = at;
            return true;
        }
    return false;
}

std::optional<QString> LineHistory::older(const QString& typed) {
    if (!at_)
        typed_ = typed;
    return walk(-1) ? std::optional(lines_[*at_]) : std::nullopt;
}

std::optional<QString> LineHistory::newer() {
    if (!at_)
        return std::nullopt;
    if (walk(1))
        return lines_[*at_];
    endWalk();
    return typed_;
}

} // namespace usar::widgets
