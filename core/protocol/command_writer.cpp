#include "core/protocol/command_writer.h"

#include "core/protocol/commands/drive_fields.h"
#include "core/protocol/commands/path_node_fields.h"
#include "core/protocol/commands/robot_fields.h"
#include "core/protocol/commands/set_fields.h"
#include "core/protocol/commands/world_fields.h"

namespace usar::protocol {

void write(const Command& command, Dialect dialect, std::string& out) {
    std::visit(
        [&]<class T>(const T& value) {
            if constexpr (std::is_same_v<T, RawCommand>) {
                out.append(value.line);
            } else {
                LineOut line(out, dialect);
                fields(line, value);
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
