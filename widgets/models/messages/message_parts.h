// A line of traffic taken apart: values with units, segments, and diagnostics.
#pragma once

#include <string>
#include <vector>

#include <QJsonObject>
#include <QString>

#include "core/base/diagnostics.h"
#include "core/protocol/fields.h"
#include "widgets/models/messages/message_row.h"

namespace usar::widgets {

/// One "{...}" segment as it was on the wire. `help` is the grammar's text for the key of a command; empty for info
/// lines.
struct MessagePart {
    std::string key;
    std::string value;
    std::string help;
};

/// Everything that the details of a row show.
struct MessageParts {
    std::vector<protocol::Field> fields; ///< info lines only; SI units and map axes if the type is known
    std::vector<MessagePart> segments;   ///< at most two thousand
    Diagnostics diagnostics;             ///< offsets in bytes of the row's text
    bool known = true;                   ///< false: no table has the type
};

/// Parses the row's text again; meant for a single row that the user looks at.
MessageParts partsOf(const MessageRow& row);

/// "0.524 rad (30.0°)": a field's value for the user.
QString valueText(const protocol::Field& field);

/// Number, time, robot, direction, type and text, separated by tabs: one line of a saved list.
QString tabbedText(const MessageRow& row, const QString& robot);
/// The same as JSON, with cause, fields and diagnostics; unknown values are omitted.
QJsonObject jsonOf(const MessageRow& row, const QString& robot);

/// Part of `text` around a byte offset and, below it, a caret under that byte; at most `width` characters wide. Bytes
/// that are not printable ASCII become blanks, so that the caret is in the right column.
struct Pointer {
    QString excerpt;
    QString caret;
};
Pointer pointerAt(std::string_view text, std::size_t offset, int width);

} // namespace usar::widgets
