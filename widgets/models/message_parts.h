// One line of traffic taken apart: its values with units, its segments, and what is wrong where.
#pragma once

#include <string>
#include <vector>

#include <QJsonObject>
#include <QString>

#include "core/base/diagnostics.h"
#include "core/protocol/fields.h"
#include "widgets/models/message_row.h"

namespace usar::widgets {

/// One "{...}" as it was on the wire. `help` is the grammar's word on a command's key.
struct MessagePart {
    std::string key;
    std::string value;
    std::string help;
};

struct MessageParts {
    std::vector<protocol::Field> fields; ///< of info lines; SI units and our frame where the type is known
    std::vector<MessagePart> segments;   ///< a few thousand at most
    Diagnostics diagnostics;             ///< offsets in bytes of the row's text
    bool known = true;                   ///< a table knows the type
};

/// Reads the text again: for one row that somebody looks at, not for all.
MessageParts partsOf(const MessageRow& row);

/// "0.524 rad (30.0°)": a field's value for people.
QString valueText(const protocol::Field& field);

/// Number, time, robot, way, type and text with tabs between: one line of a saved list.
QString tabbedText(const MessageRow& row, const QString& robot);
/// The same with cause, fields and diagnostics. What is not there is left out.
QJsonObject jsonOf(const MessageRow& row, const QString& robot);

/// Part of `text` around a byte offset and, below it, a caret under that byte; at most `width` characters wide. Bytes
/// that are not printable become blanks, so that the caret stands right.
struct Pointer {
    QString excerpt;
    QString caret;
};
Pointer pointerAt(std::string_view text, std::size_t offset, int width);

} // namespace usar::widgets
