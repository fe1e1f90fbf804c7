// History of sent lines, oldest first, with a walk through the lines that contain the typed text.
#pragma once

#include <optional>

#include <QStringList>

namespace usar::widgets {

/// A value. A line that is sent again moves to the end; beyond `limit` lines the oldest is removed.
class LineHistory {
public:
    static constexpr qsizetype limit = 200;

    const QStringList& lines() const { return lines_; }
    /// Keeps the newest `limit` lines and ends the walk.
    void setLines(const QStringList& lines);
    /// Appends a sent line and ends the walk.
    void add(const QString& line);

    /// Returns the next older line that contains `typed`, ignoring case; nullopt at the oldest. The first call begins a
    /// walk and remembers `typed`.
    std::optional<QString> older(const QString& typed);
    /// Steps back toward the typed text, which is returned last; nullopt if no walk is in progress.
    std::optional<QString> newer();
    /// The next older() begins a new walk.
    void endWalk() { at_.reset(); }

private:
    /// Moves the walk by `step` (1 or -1) to the next line that contains the typed text; returns false if there is
    /// none.
    bool walk(qsizetype step);

    QStringList lines_;
    QString typed_;
    std::optional<qsizetype> at_; ///< index of the line that the walk is at
};

} // namespace usar::widgets
