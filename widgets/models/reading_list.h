// Readings as rows of a list, each with its unit, its place in its range and its age: joints, wheels, touch, ranges,
// ball, victims, tags, gas and the like.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/protocol/info_message.h"
#include "widgets/models/fitting.h"
#include "widgets/models/heard.h"

namespace usar::widgets {

/// A shape beside the value of a row, because a state is never a color alone.
enum class RowMark { None, Off, On };

/// One reading, formatted.
struct ReadingRow {
    QString name{};
    QString value{}; ///< a dash if the server sent no number
    QString unit{};  ///< empty: the value has none, or no source tells it
    RowMark mark = RowMark::None;
    /// Where the value lies in its range, 0..1; nullopt if there is no range to show.
    std::optional<double> share{};
    std::optional<double> zero_share{}; ///< where zero lies in that range; nullopt: the bar begins at the left
    Heard heard{};

    /// "F1 2.40 m"
    QString text() const;
};

/// All readings of one kind, such as the encoders of a robot.
struct ReadingList {
    std::string key;       ///< the same for every message of this list, "Encoder"
    QString title;         ///< "encoders"
    QString help;          ///< what the figures are, with unit and range
    bool replaces = false; ///< a message has all rows there are; otherwise it has some, and the others stay
    std::vector<ReadingRow> rows{};
    Heard heard{};

    /// True if all rows are stale.
    bool stale(Seconds now) const;
};

/// The list that a message brings with the rows that it has; nullopt if its readings have no list. Nothing is marked as
/// heard. Ranges of sensors that look down are left out, because they are a figure of their own.
std::optional<ReadingList> readingsOf(const protocol::InfoMessage& message, const Fitting& fitting);

/// Takes the rows of `news`, heard at `at`, into `list`, whose other rows stay unless the message has all of them.
void take(ReadingList& list, ReadingList news, Seconds at);

} // namespace usar::widgets
