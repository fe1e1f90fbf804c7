// One line of protocol as a JSON object, for scripts and for anybody's log: what `usar-mission lines` prints.
#pragma once

#include <cstdint>
#include <string_view>

#include <QIODevice>
#include <QJsonObject>

#include "core/base/result.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// Reads lines of both directions; a line is taken for a command where its first word is one, else for the server's.
/// One log, in its order.
class LineReporter {
public:
    /// `line` is its number in the file. The object has `line`, `direction` ("in" from the server, "out" to it), `type`
    /// ("SEN Sonar", "DRIVE"), `container` (our struct), `fields` (objects with `item`, `field`, `value`, `unit`; SI
    /// units, our frame), `diagnostics` (objects with `severity`, `column` from 1, `message`) and `text`.
    QJsonObject report(std::string_view text, std::uint64_t line);

private:
    protocol::Reader reader_;
};

/// What was in a whole log.
struct LineCounts {
    std::uint64_t lines = 0;
    std::uint64_t with_diagnostics = 0;
};

/// Prints an object for each line of `input`, whatever ends it; empty lines and those that begin with # are passed
/// over. A line longer than the reader's cap is left out with a diagnostic. Refused when `output` takes no more.
Result<LineCounts> reportLines(QIODevice& input, QIODevice& output);

} // namespace usar::mission
