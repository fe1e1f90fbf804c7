#include "core/protocol/reader.h"

#include "core/protocol/readers/table.h"

namespace usar::protocol {

namespace {

GenericMessage genericFrom(const Segments& segments) {
    GenericMessage message;
    message.type_word = segments.typeWord();
    message.type = segments.value("Type");
    message.name = NamedPairs(segments.value("Name")).name();
    message.segments.reserve(segments.all().size());
    for (const Segment& segment : segments.all())
        message.segments.push_back({std::string(segment.key), std::string(segment.value)});
    return message;
}

} // namespace

InfoLine Reader::read(std::string_view line) {
    InfoLine result;
    result.number = last_ = LineNumber{last_.value + 1};
    result.text = line;
    segments_.read(line, result.diagnostics);
    const ReadFunction function = readFunctionFor(segments_.typeWord(), segments_.value("Type"));
    if (function) {
        LineReading reading(segments_, result.diagnostics);
        if (std::optional<InfoMessage> message = function(reading)) {
            result.message = std::move(*message);
            return result;
        }
    }
    result.message = genericFrom(segments_);
    return result;
}

} // namespace usar::protocol
