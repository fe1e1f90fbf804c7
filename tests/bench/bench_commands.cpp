// Commands to lines: ours beside the usual way of a client, a string stream for each line.
#include <benchmark/benchmark.h>

#include <sstream>

#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"

using namespace usar;
using namespace usar::protocol;

namespace {

/// What a busy behavior says in a tick: two drives, two joints, a camera, a question and a setting.
std::vector<Command> busyTick() {
    return {SkidDrive{1.2345, -0.98765},
            AerialDrive{0.5, 1.25, -0.125, 0.333333},
            MultiDrive{{{"FRFlipper", 0.5}, {"FLFlipper", 0.52}, {"RRFlipper", -0.5}, {"RLFlipper", -0.52}}},
            PackageDrive{"CameraPanTilt", {{1, 1.5}, {2, -0.25}}},
            GetGeometry{"RangeScanner", "lms200"},
            SetInsPose{"INS", {{4.5, -1.9, 1.8}, 0.01, -0.02, 1.57}}};
}

void setRates(benchmark::State& state, std::size_t lines, std::size_t bytes) {
    state.SetItemsProcessed(static_cast<std::int64_t>(lines));
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}

void BM_WriteCommands(benchmark::State& state) {
    const std::vector<Command> commands = busyTick();
    std::string out;
    std::size_t bytes = 0;
    for (auto _ : state) {
        out.clear();
        for (const Command& command : commands) {
            write(command, Dialect::Ut2004, out);
            out += "\r\n";
        }
        bytes += out.size();
        benchmark::DoNotOptimize(out.data());
    }
    setRates(state, commands.size() * static_cast<std::size_t>(state.iterations()), bytes);
}

/// Short numbers, as a stream prints them by default: it does less, for its lines do not read back to the same values.
struct Streamed {
    std::ostringstream out;

    void operator()(const SkidDrive& drive) {
        out << "DRIVE {Left " << *drive.left_rad_s << "} {Right " << *drive.right_rad_s << "} {Normalized false}";
    }
    void operator()(const AerialDrive& drive) {
        out << "DRIVE {AltitudeVelocity " << *drive.climb_m_s << "} {LinearVelocity " << *drive.forward_m_s
            << "} {LateralVelocity " << -*drive.left_m_s << "} {RotationalVelocity " << -*drive.yaw_rate_rad_s
            << "} {Normalized false}";
    }
    void operator()(const MultiDrive& drive) {
        out << "MULTIDRIVE";
        for (const JointAngleTarget& target : drive.joints)
            out << " {" << target.joint.text() << " " << target.angle_rad << "}";
    }
    void operator()(const PackageDrive& drive) {
        out << "MISPKG {Name " << drive.package.text() << "}";
        for (const LinkTarget& target : drive.links)
            out << " {Link " << target.link << "} {Value " << target.value << "} {Order "
                << static_cast<int>(target.order) << "}";
    }
    void operator()(const GetGeometry& get) {
        out << "GETGEO {Type " << get.type.text() << "} {Name " << get.name.text() << "}";
    }
    void operator()(const SetInsPose& set) {
        const Vec3& p = set.base_in_map.position_m;
        out << "SET {Type INS} {Name " << set.sensor_name.text() << "} {Opcode POSE} {Params " << p.x() << "," << -p.y()
            << "," << -p.z() << "," << set.base_in_map.roll_rad << "," << -set.base_in_map.pitch_rad << ","
            << -set.base_in_map.yaw_rad << "}";
    }
    template <class Other>
    void operator()(const Other&) {}
};

void BM_StreamCommands(benchmark::State& state) {
    const std::vector<Command> commands = busyTick();
    std::size_t bytes = 0;
    for (auto _ : state) {
        for (const Command& command : commands) {
            Streamed stream;
            std::visit(stream, command);
            const std::string line = stream.out.str() + "\r\n";
            bytes += line.size();
            benchmark::DoNotOptimize(line.data());
        }
    }
    setRates(state, commands.size() * static_cast<std::size_t>(state.iterations()), bytes);
}

void BM_ReadCommands(benchmark::State& state) {
    std::vector<std::string> lines;
    for (const Command& command : busyTick())
        lines.push_back(write(command));
    std::size_t bytes = 0;
    Diagnostics diagnostics;
    for (auto _ : state) {
        for (const std::string& line : lines) {
            const Command command = readCommand(line, diagnostics);
            benchmark::DoNotOptimize(&command);
            bytes += line.size();
        }
    }
    setRates(state, lines.size() * static_cast<std::size_t>(state.iterations()), bytes);
}

} // namespace

BENCHMARK(BM_WriteCommands);
BENCHMARK(BM_StreamCommands);
BENCHMARK(BM_ReadCommands);
