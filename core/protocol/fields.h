// Converts any info message, of a known type or not, to a flat list of named values for sensor panels, plots and
// exports.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::protocol {

/// One value of a message. `source` names the stream ("SEN Sonar", "STA"), `item` the sensor or group ("F1",
/// "CameraPanTilt Link 1"; may be empty), `field` the value within it ("range", "x"). Numbers are in SI units and in
/// our frame, except those of a generic message, whose meaning is unknown and which stay as they are on the wire.
/// `number` is absent for texts and for NaN, whose text is "nan".
struct Field {
    std::string source{};
    std::string item{};
    std::string field{};
    std::optional<double> number{};
    std::string text{};
    std::string unit{}; ///< "m", "rad", "s", "" …

    /// "SEN Sonar/F1/range", or "STA/battery" without an item. Every message of a stream has the same paths.
    std::string path() const;
    bool operator==(const Field&) const = default;
};

class FieldList;

/// Adds all values of `message` to `fields`; the lists below are made by these two.
void listFields(const InfoMessage& message, FieldList& fields);
void listGenericFields(const GenericMessage& message, FieldList& fields);

/// All values of `message` except its time, in the server's order. A vector gives one field per axis. A long list, such
/// as a scan, gives its count and the minimum, mean and maximum of its finite values.
std::vector<Field> fieldsOf(const InfoMessage& message);
/// Lists all values of a message of unknown type except Type and Time. Follows the grouping rule of protocol.md 1.4: a
/// segment belongs to the last group-opening key before it (Name, then Link, ID, PartName, Object, WheelNumber or
/// ViewportN within it), which gives the item its name: "CameraPanTilt Link 1". Values stay in the wire's frame and
/// units: numbers as numbers, vectors by axis, everything else as text.
std::vector<Field> genericFieldsOf(const GenericMessage& message);

/// The name of the struct that holds the message: "RangeScan", "GenericMessage".
std::string_view containerOf(const InfoMessage& message);
/// The message's own time stamp on the server's clock; nullopt if it carries none.
std::optional<Seconds> timeOf(const InfoMessage& message);

} // namespace usar::protocol
