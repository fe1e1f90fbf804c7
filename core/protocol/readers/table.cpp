#include "core/protocol/readers/table.h"

#include <algorithm>
#include <array>

namespace usar::protocol {

ReadFunction readFunctionFor(std::string_view type_word, std::string_view type) {
    static constexpr std::array rows = {
        ReaderRow{"SEN", "Sonar", readSonars},      ReaderRow{"SEN", "RangeScanner", readRangeScan},
        ReaderRow{"SEN", "INS", readIns},           ReaderRow{"SEN", "GroundTruth", readGroundTruth},
        ReaderRow{"SEN", "Odometry", readOdometry}, ReaderRow{"SEN", "Encoder", readEncoders},
        ReaderRow{"SEN", "", readRangeScanByShape}, ReaderRow{"STA", "", readRobotState},
        ReaderRow{"NFO", "", readGameInfo},         ReaderRow{"GEO", "", readGeometry},
        ReaderRow{"CONF", "", readConfiguration},   ReaderRow{"RES", "", readResponse},
    };
    const auto row = std::ranges::find_if(rows, [&](const ReaderRow& r) {
        return sameWord(r.type_word, type_word) && (r.type.empty() || sameWord(r.type, type));
    });
    return row == rows.end() ? nullptr : row->read;
}

} // namespace usar::protocol
