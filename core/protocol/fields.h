// Any info message as a flat list of named values: what sensor panels, plots and exports show, known type or not.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::protocol {

/// One value of a message. `source` names the stream ("SEN Sonar", "STA"), `item` the sensor or group ("F1",
/// "CameraPanTilt Link 1", may be empty), `field` the value within it ("range", "x"). Numbers carry SI units in our
/// frame; those of a generic message are as the wire has them, for nobody knows what they mean. A text has no number,
/// nor has a NaN, whose text is "nan".
struct Field {
    std::string source{};
    std::string item{};
    std::string field{};
    std::optional<double> number{};
    std::string text{};
    std::string unit{}; ///< "m", "rad", "s", "" …

    /// "SEN Sonar/F1/range", or "STA/battery" without an item; the same for a stream's every message.
    std::string path() const;
    bool operator==(const Field&) const = default;
};

/// All values of `message` in the server's order, but for its time. Vectors give a field an axis; long lists (a scan)
/// give count, minimum, mean and maximum of what is a number.
std::vector<Field> fieldsOf(const InfoMessage& message);
/// The name of the struct that holds the message: "RangeScan", "GenericMessage".
std::string_view containerOf(const InfoMessage& message);
/// The message's own time stamp, if it carries one.
std::optional<Seconds> timeOf(const InfoMessage& message);

} // namespace usar::protocol
