// The table of info messages: which function reads which line. A new type is one small file beside this one, one row in
// table.cpp and one declaration here.
#pragma once

#include <optional>
#include <string_view>

#include "core/protocol/info_message.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

/// Gives the value, or nothing when the line must stay a GenericMessage: without a diagnostic where it says nothing (a
/// bare head), holds nothing that the value could take, or is of another shape, with one where it is damaged.
using ReadFunction = std::optional<InfoMessage> (*)(LineReading& line);

/// `type` is the value of the Type segment; empty takes any. Both are compared without regard to case.
struct ReaderRow {
    std::string_view type_word;
    std::string_view type;
    ReadFunction read;
};

/// The function of the first row that fits, or nullptr.
ReadFunction readFunctionFor(std::string_view type_word, std::string_view type);

std::optional<InfoMessage> readConfiguration(LineReading& line);
std::optional<InfoMessage> readEncoders(LineReading& line);
std::optional<InfoMessage> readGameInfo(LineReading& line);
std::optional<InfoMessage> readGeometry(LineReading& line);
std::optional<InfoMessage> readGroundTruth(LineReading& line);
std::optional<InfoMessage> readIns(LineReading& line);
std::optional<InfoMessage> readOdometry(LineReading& line);
std::optional<InfoMessage> readRangeScan(LineReading& line);
/// Scanners go by many names (RangeScanner, IRScanner, Laser …): any SEN with one FOV, one Resolution and a Range.
std::optional<InfoMessage> readRangeScanByShape(LineReading& line);
std::optional<InfoMessage> readResponse(LineReading& line);
std::optional<InfoMessage> readRobotState(LineReading& line);
std::optional<InfoMessage> readSonars(LineReading& line);

} // namespace usar::protocol
