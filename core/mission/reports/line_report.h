// A protocol line as a JSON object, for scripts and for logs of any origin: the output of `usar-mission lines`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <QIODevice>

#include "core/base/result.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// Appends the report on one line of a log to `out`, with a line end; returns whether it has diagnostics. The lines of
/// a log share a reader and come in their order, in both directions. A line counts as a command if its first word is
/// one, else as a line from the server. `text` has no line end, `line` is its number in the file. The object has
/// `line`, `direction` ("in" from the server, "out" to it), `type` ("SEN Sonar", "DRIVE"), `container` (our struct),
/// `time` (s, on the server's clock; not where the line tells none), `fields` (objects with `item`, `field`, `unit`,
/// and `value` or, for a list such as a scan, all its `values`; SI units and our frame for lines from the server, as on
/// the wire for commands), `unread` (keys that the line's kind does not have, with their values; only if there are
/// any), `diagnostics` (objects with `severity`, `column` from 1, `message`) and `text`. Numbers that are not finite
/// are "nan".
bool reportLine(protocol::Reader& reader, std::string_view text, std::uint64_t line, std::string& out);

/// Line counts of a whole log.
struct LineCounts {
    std::uint64_t lines = 0;
    std::uint64_t with_diagnostics = 0;
};

/// Prints one JSON object per line of `input`, in order, whatever its line ends; skips empty lines and those that begin
/// with #. A line longer than the reader's cap is reported with a diagnostic and without fields. Uses all cores. Fails
/// if `output` accepts no more.
Result<LineCounts> reportLines(QIODevice& input, QIODevice& output);

} // namespace usar::mission
