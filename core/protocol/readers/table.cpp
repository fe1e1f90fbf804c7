#include "core/protocol/readers/table.h"

#include <algorithm>
#include <type_traits>

#include "core/protocol/readers/described.h"
#include "core/protocol/readers/info_readers.h"

namespace usar::protocol {

namespace {

template <class T, class... Types>
constexpr std::size_t indexIn(const std::variant<Types...>*) {
    std::size_t index = 0;
    std::size_t i = 0;
    ((std::is_same_v<T, Types> ? index = i : index, ++i), ...);
    return index;
}

template <class T>
bool readInto(LineReading& line, InfoMessage& message) {
    T& out = *std::get_if<T>(&message);
    if constexpr (Described<T> && SensorMessage<T>)
        return readDescribed(line, out);
    else
        return read(line, out);
}

template <class T>
ReaderRow rowOf(std::string_view type_word, std::string_view type = {}, bool (*fits)(const Segments&) = nullptr) {
    return {type_word, type, fits, indexIn<T>(static_cast<const InfoMessage*>(nullptr)), readInto<T>};
}

/// Adds a row for each word in the sensor's `wire_types`, such as "IR|Range".
template <class Sensor>
void addSensor(std::vector<ReaderRow>& rows) {
    forEachType(Sensor::wire_types, [&rows](std::string_view type) {
        rows.push_back(rowOf<Sensor>("SEN", type));
        if constexpr (requires { Sensor::fits; })
            rows.back().fits = Sensor::fits;
    });
}

template <class... Sensors>
void addSensors(std::vector<ReaderRow>& rows, TypeList<Sensors...>) {
    (addSensor<Sensors>(rows), ...);
}

std::vector<ReaderRow> makeRows() {
    std::vector<ReaderRow> rows;
    addSensors(rows, SensorTypes{});
    ReaderRow by_shape = rowOf<RangeScan>("SEN");
    by_shape.read = [](LineReading& line, InfoMessage& message) {
        return readByShape(line, *std::get_if<RangeScan>(&message));
    };
    rows.push_back(by_shape);
    // The answer to CONTROL GetSTA is an STA about objects in the world: each has a Name; a robot's state has none.
    rows.push_back(rowOf<WorldObjects>(
        "STA", "", [](const Segments& s) { return s.all().empty() || s.find("Name") || s.find("Size"); }));
    rows.push_back(rowOf<RobotState>("STA"));
    rows.push_back(rowOf<PackageState>("MISSTA"));
    rows.push_back(rowOf<PackageState>("ASTA"));
    rows.push_back(rowOf<EffecterState>("EFF"));
    rows.push_back(rowOf<GeometryInfo>("GEO"));
    rows.push_back(rowOf<ConfigurationInfo>("CONF"));
    rows.push_back(rowOf<Response>("RES"));
    rows.push_back(rowOf<StartPoses>("NFO", "", [](const Segments& s) { return s.find("StartPoses") != nullptr; }));
    rows.push_back(rowOf<PathNodes>("NFO", "", [](const Segments& s) { return s.find("PathNodes") != nullptr; }));
    rows.push_back(rowOf<ClosestPathNode>("NFO", "", [](const Segments& s) { return s.find("Pathnode") != nullptr; }));
    rows.push_back(rowOf<LockstepInfo>("NFO", "", [](const Segments& s) { return s.find("Lockstep") != nullptr; }));
    rows.push_back(rowOf<GameInfo>("NFO"));
    return rows;
}

const std::vector<ReaderRow>& allRows() {
    static const std::vector<ReaderRow> rows = makeRows();
    return rows;
}

} // namespace

bool isKnownSensor(std::string_view type) {
    return std::ranges::any_of(allRows(), [type](const ReaderRow& row) {
        return sameWord(row.type_word, "SEN") && !row.type.empty() && sameWord(row.type, type);
    });
}

const ReaderRow* readerRowFor(const Segments& segments) {
    const std::vector<ReaderRow>& rows = allRows();
    const std::string_view word = segments.typeWord();
    const std::string_view type = segments.value("Type");
    const auto row = std::ranges::find_if(rows, [&](const ReaderRow& r) {
        return sameWord(r.type_word, word) && (r.type.empty() || sameWord(r.type, type)) &&
               (!r.fits || r.fits(segments));
    });
    return row == rows.end() ? nullptr : &*row;
}

} // namespace usar::protocol
