#include "core/protocol/command_writer.h"

#include "core/protocol/commands/line_out.h"

namespace usar::protocol {

void write(const Command& command, Dialect dialect, std::string& out) {
    std::visit(
        [&]<class T>(const T& value) {
            if constexpr (std::is_same_v<T, RawCommand>) {
                out.append(value.line);
            } else {
                out.append(T::word.word);
                LineOut line(out, dialect);
                T::segments(line, value);
            }
        },
        command);
}

std::string write(const Command& command, Dialect dialect) {
    std::string line;
    write(command, dialect, line);
    return line;
}

} // namespace usar::protocol
