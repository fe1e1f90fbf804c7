// Any bytes through everything that reads the wire: splitter, info reader, lists of values, writer, command reader and
// the check of the command box. libFuzzer with address and undefined-behavior sanitizers watches; what is asserted here
// is that writing what was read is stable.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/protocol/command_grammar.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/fields.h"
#include "core/protocol/info/configurations.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/reader.h"
#include "core/protocol/writer.h"

namespace {

using namespace usar;
using namespace usar::protocol;

void readInfo(Reader& reader, std::string_view line) {
    const InfoLine& result = reader.read(line);
    if (result.text != line || result.diagnostics.size() > 16)
        std::abort();
    for (const Diagnostic& diagnostic : result.diagnostics)
        if (diagnostic.offset > line.size())
            std::abort();
    fieldsOf(result.message);
    timeOf(result.message);
    if (const auto* const configuration = std::get_if<ConfigurationInfo>(&result.message)) {
        robotConfigurationOf(*configuration);
        packageConfigurationsOf(*configuration);
        cameraConfigurationsOf(*configuration);
        effecterConfigurationsOf(*configuration);
        sensorConfigurationsOf(*configuration);
    }
    std::string written;
    write(result.message, written);
}

void readOneCommand(std::string_view line) {
    for (const Dialect dialect : {Dialect::Ut2004, Dialect::Udk}) {
        Diagnostics diagnostics;
        const Command command = readCommand(line, diagnostics, dialect);
        write(command, dialect);
    }
}

/// What a person sees while typing: looking for the nearest words takes a hundred times longer than reading.
void helpTyping(std::string_view line) {
    checkCommand(line);
    completionsAt(line, line.size());
    completionsAt(line, line.size() / 2);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Reader reader; // as one connection has it: places are used again
    LineSplitter splitter(4096);
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto take = [](std::string_view line) {
        readInfo(reader, line);
        readOneCommand(line);
        if (line.size() % 32 == 0)
            helpTyping(line);
    };
    // In two pieces, as a socket gives them, and with an end for what has none.
    splitter.feed(bytes.substr(0, size / 2), take);
    splitter.feed(bytes.substr(size / 2), take);
    splitter.feed("\n", take);
    return 0;
}
