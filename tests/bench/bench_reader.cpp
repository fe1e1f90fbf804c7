// What reading costs a byte: 181-beam scans and whole ticks of a UT2004 server, beside a bare loop over the same
// numbers and a reader of the usual make (every segment into a map, every number with strtod).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/protocol/line_splitter.h"
#include "core/protocol/reader.h"
#include "core/protocol/writer.h"

namespace {

using namespace usar;
using namespace usar::protocol;

constexpr int ticks = 64;

RangeScan scanAt(int tick, Random& random) {
    RangeScan scan{Seconds(0.2 * tick), "Scanner1", 0.01745, pi, {}};
    for (int beam = 0; beam < 181; ++beam)
        scan.ranges_m.push_back(uniform(random, 0.1, 20.0));
    return scan;
}

std::vector<std::string> scanLines() {
    Random random = seeded(1, 1);
    std::vector<std::string> lines(ticks);
    for (int tick = 0; tick < ticks; ++tick)
        write(scanAt(tick, random), lines[static_cast<std::size_t>(tick)]);
    return lines;
}

/// In the order of a tick (protocol.md 1.8): sonars, scanner, INS, odometry, encoders, ground truth, GPS, a
/// package, state.
std::vector<std::string> trafficLines() {
    Random random = seeded(1, 2);
    std::vector<std::string> lines;
    for (int tick = 0; tick < ticks; ++tick) {
        const Seconds time(0.2 * tick);
        const Pose pose{{uniform(random, 0, 9), 2, 3}, 0, 0.01, uniform(random, -3, 3)};
        SonarReadings sonars{time, {}};
        for (int i = 1; i <= 8; ++i)
            sonars.ranges.push_back({"F" + std::to_string(i), uniform(random, 0.1, 5.0)});
        const PackageState package{time, "CameraPanTilt", {{1, 0.1, -20.0}, {2, -0.2, -20.0}}};
        for (const InfoMessage& message : std::initializer_list<InfoMessage>{
                 sonars, scanAt(tick, random), InsReading{std::nullopt, "INS", pose},
                 OdometryReading{std::nullopt, "Odometry", pose},
                 EncoderReadings{std::nullopt, {{"ECLeft", tick}, {"ECRight", -tick}}},
                 GroundTruthReading{time, "GroundTruth", pose},
                 GpsReading{.name = "GPS", .fix = false, .satellites = 0}, package,
                 RobotState{
                     .kind = VehicleKind::Ground, .time = time, .battery_left = Seconds(1200), .light_on = false}})
            write(message, lines.emplace_back());
    }
    return lines;
}

std::int64_t bytesOf(const std::vector<std::string>& lines) {
    std::size_t bytes = 0;
    for (const std::string& line : lines)
        bytes += line.size();
    return static_cast<std::int64_t>(bytes);
}

/// Runs `read` over the lines and reports bytes and lines a second.
template <class Read>
void readAll(benchmark::State& state, const std::vector<std::string>& lines, Read&& read) {
    for (auto _ : state) {
        for (const std::string& line : lines)
            benchmark::DoNotOptimize(read(line));
    }
    state.SetBytesProcessed(state.iterations() * bytesOf(lines));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(lines.size()));
}

const InfoLine* readTyped(Reader& reader, const std::string& line) {
    return &reader.read(line);
}

/// The least that any reader must do: every number of the line, into a list that is reused.
std::size_t readNumbersOnly(const std::string& line, std::vector<double>& numbers) {
    numbers.clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    while (at != end) {
        double value = 0.0;
        const auto [behind, problem] = std::from_chars(at, end, value);
        if (problem == std::errc{}) {
            numbers.push_back(value);
            at = behind;
        } else {
            ++at;
        }
    }
    return numbers.size();
}

std::vector<double> numbersByStrtod(const std::string& value) {
    std::vector<double> numbers;
    for (std::size_t start = 0; start <= value.size();) {
        const std::size_t comma = std::min(value.find(',', start), value.size());
        numbers.push_back(std::strtod(value.substr(start, comma - start).c_str(), nullptr));
        start = comma + 1;
    }
    return numbers;
}

/// As many clients do it, losing repeated keys.
std::map<std::string, std::vector<double>> readIntoMap(const std::string& line) {
    std::map<std::string, std::vector<double>> segments;
    for (std::size_t open = line.find('{'); open != std::string::npos; open = line.find('{', open + 1)) {
        const std::string text = line.substr(open + 1, line.find('}', open) - open - 1);
        const std::size_t space = std::min(text.find(' '), text.size());
        segments[text.substr(0, space)] = numbersByStrtod(text.substr(std::min(space + 1, text.size())));
    }
    return segments;
}

void readScans(benchmark::State& state) {
    Reader reader;
    readAll(state, scanLines(), [&reader](const std::string& line) { return readTyped(reader, line); });
}
BENCHMARK(readScans);

void readScansBareFromChars(benchmark::State& state) {
    std::vector<double> numbers;
    readAll(state, scanLines(), [&numbers](const std::string& line) { return readNumbersOnly(line, numbers); });
}
BENCHMARK(readScansBareFromChars);

void readScansMapAndStrtod(benchmark::State& state) {
    readAll(state, scanLines(), readIntoMap);
}
BENCHMARK(readScansMapAndStrtod);

void readTraffic(benchmark::State& state) {
    Reader reader;
    readAll(state, trafficLines(), [&reader](const std::string& line) { return readTyped(reader, line); });
}
BENCHMARK(readTraffic);

void readTrafficBareFromChars(benchmark::State& state) {
    std::vector<double> numbers;
    readAll(state, trafficLines(), [&numbers](const std::string& line) { return readNumbersOnly(line, numbers); });
}
BENCHMARK(readTrafficBareFromChars);

void readTrafficMapAndStrtod(benchmark::State& state) {
    readAll(state, trafficLines(), readIntoMap);
}
BENCHMARK(readTrafficMapAndStrtod);

/// From bytes in chunks of 1024, as the captured server's sockets gave them, to values.
void splitAndReadTraffic(benchmark::State& state) {
    std::string bytes;
    for (const std::string& line : trafficLines())
        bytes += line + "\r\n";
    LineSplitter splitter;
    Reader reader;
    for (auto _ : state) {
        for (std::size_t at = 0; at < bytes.size(); at += 1024)
            splitter.feed(std::string_view(bytes).substr(at, 1024),
                          [&reader](std::string_view line) { benchmark::DoNotOptimize(reader.read(line)); });
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(splitAndReadTraffic);

void writeScans(benchmark::State& state) {
    Random random = seeded(1, 3);
    const InfoMessage scan = scanAt(1, random);
    std::string line;
    for (auto _ : state) {
        line.clear();
        write(scan, line);
        benchmark::DoNotOptimize(line.data());
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(line.size()));
}
BENCHMARK(writeScans);

} // namespace
