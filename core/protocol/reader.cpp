#include "core/protocol/reader.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "core/protocol/readers/described.h"
#include "core/protocol/readers/info_readers.h"

namespace usar::protocol {

namespace {

/// The buffers are freed after a longer line, so that one hostile line does not occupy memory forever.
constexpr std::size_t most_kept_bytes = 1u << 20;

/// One row of the table of messages. It applies to lines with this type word and this value of the Type segment (empty
/// matches any), both compared ignoring case, for which `fits`, unless null, returns true.
struct ReaderRow {
    std::string_view type_word;
    std::string_view type;
    bool (*fits)(const Segments& segments) = nullptr;
    std::size_t kind = 0;      ///< index of the alternative of InfoMessage that the line fills
    bool by_shape = false;     ///< the Type is unknown, and only the line's segments tell whether it is a scan
    bool speaks_always = true; ///< false for a sensor that sends nothing while there is nothing to report
};

template <class T, class... Types>
constexpr std::size_t indexIn(const std::variant<Types...>*) {
    std::size_t index = 0;
    std::size_t i = 0;
    ((std::is_same_v<T, Types> ? index = i : index, ++i), ...);
    return index;
}

template <class T>
ReaderRow rowOf(std::string_view type_word, std::string_view type = {}, bool (*fits)(const Segments&) = nullptr) {
    return {type_word, type, fits, indexIn<T>(static_cast<const InfoMessage*>(nullptr))};
}

/// Adds a row for each word in the sensor's `wire_types`, such as "IR|Range".
template <class Sensor>
void addSensor(std::vector<ReaderRow>& rows) {
    forEachType(Sensor::wire_types, [&rows](std::string_view type) {
        ReaderRow& row = rows.emplace_back(rowOf<Sensor>("SEN", type));
        if constexpr (requires { Sensor::fits; })
            row.fits = Sensor::fits;
        if constexpr (requires { Sensor::speaks_always; })
            row.speaks_always = Sensor::speaks_always;
    });
}

template <class... Sensors>
void addSensors(std::vector<ReaderRow>& rows, TypeList<Sensors...>) {
    (addSensor<Sensors>(rows), ...);
}

std::vector<ReaderRow> makeRows() {
    std::vector<ReaderRow> rows;
    addSensors(rows, SensorTypes{});
    rows.emplace_back(rowOf<RangeScan>("SEN")).by_shape = true;
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

const std::vector<ReaderRow>& readerRows() {
    static const std::vector<ReaderRow> rows = makeRows();
    return rows;
}

/// The first row that applies to the line, or nullptr.
const ReaderRow* readerRowFor(const Segments& segments) {
    const std::string_view word = segments.typeWord();
    const std::string_view type = segments.value("Type");
    const auto row = std::ranges::find_if(readerRows(), [&](const ReaderRow& r) {
        return sameWord(r.type_word, word) && (r.type.empty() || sameWord(r.type, type)) &&
               (!r.fits || r.fits(segments));
    });
    return row == readerRows().end() ? nullptr : &*row;
}

template <std::size_t... Kinds>
std::vector<InfoLine> makePlaces(std::index_sequence<Kinds...>) {
    std::vector<InfoLine> places(sizeof...(Kinds));
    (places[Kinds].message.emplace<Kinds>(), ...);
    return places;
}

void fill(GenericMessage& message, const Segments& segments) {
    message.type_word = segments.typeWord();
    message.type = segments.value("Type");
    message.name = NamedPairs(segments.value("Name")).name();
    Refill<KeyValue> kept(message.segments);
    for (const Segment& segment : segments.all()) {
        KeyValue& next = kept.next();
        next.key = segment.key;
        next.value = segment.value;
    }
}

bool isText(std::string_view word) {
    return std::ranges::none_of(word, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; });
}

} // namespace

bool isKnownSensor(std::string_view type) {
    return std::ranges::any_of(readerRows(), [type](const ReaderRow& row) {
        return sameWord(row.type_word, "SEN") && !row.type.empty() && sameWord(row.type, type);
    });
}

bool speaksAlways(std::string_view type) {
    return std::ranges::none_of(
        readerRows(), [type](const ReaderRow& row) { return !row.speaks_always && sameWord(row.type, type); });
}

void Reader::forgetBuffers() {
    segments_ = {};
    pairs_ = {};
    places_ = makePlaces(std::make_index_sequence<std::variant_size_v<InfoVariant>>());
}

const InfoLine& Reader::read(std::string_view line) {
    if (std::exchange(was_long_, line.size() > most_kept_bytes))
        forgetBuffers();
    diagnostics_.clear();
    last_ = LineNumber{last_.value + 1};
    segments_.read(line, diagnostics_);
    const ReaderRow* row = readerRowFor(segments_);
    if (row) {
        LineReading reading(segments_, diagnostics_, pairs_);
        const auto fillIn = [&]<class T>(T& out) {
            if constexpr (std::is_same_v<T, RangeScan>)
                return row->by_shape ? readByShape(reading, out) : protocol::read(reading, out);
            else if constexpr (Described<T> && SensorMessage<T>)
                return readDescribed(reading, out);
            else if constexpr (!std::is_same_v<T, GenericMessage>)
                return protocol::read(reading, out);
            return false;
        };
        if (!std::visit(fillIn, static_cast<InfoVariant&>(places_[row->kind].message)))
            row = nullptr; // The line must stay generic.
    }
    InfoLine& result = places_[row ? row->kind : 0];
    if (!row) {
        fill(std::get<GenericMessage>(result.message), segments_);
        if (!isText(segments_.typeWord()))
            diagnostics_.push_back({Severity::Warning, 0, "this is no message: its first word is not text"});
    }
    result.number = last_;
    result.text = line;
    std::swap(result.diagnostics, diagnostics_);
    return result;
}

} // namespace usar::protocol
