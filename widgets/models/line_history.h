// Lines that were sent before, oldest first, and a walk through those that contain what was typed.
#pragma once

#include <optional>

#include <QStringList>

namespace usar::widgets {

/// A value. A line that is sent again moves to the end; the oldest of more than `limit` falls out.
class LineHistory {
public:
    static constexpr qsizetype limit = 200;

    const QStringList& lines() const { return lines_; }
    void setLines(const QStringList& lines);
    void add(const QString& line);

    /// The next older line that contains `typed`, whatever the case; the walk begins at the first call. Nothing at its
    /// end.
    std::optional<QString> older(const QString& typed);
    /// Back toward what was typed, which comes last; nothing where no walk is on.
    std::optional<QString> newer();
    /// The next `older` begins anew.
    void endWalk() { at_.reset(); }

private:
    bool fits(qsizetype at) const;

    QStringList lines_;
    QString typed_;
    std::optional<qsizetype> at_;
};

} // namespace usar::widgets
