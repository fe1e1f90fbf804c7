#include "core/protocol/reader.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/protocol/readers/table.h"
#include "core/protocol/refill.h"

namespace usar::protocol {

namespace {

/// The buffers are freed after a longer line, so that one hostile line does not occupy memory forever.
constexpr std::size_t most_kept_bytes = 1u << 20;

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

Reader::Reader() {
    forgetBuffers();
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
        if (!row->read(reading, places_[row->kind].message))
            row = nullptr;
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
