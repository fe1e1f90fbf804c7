// What recording costs: the same records of a flight as version 1, which does not compress, and as version 2, in one
// run, so that the ratios hold on a machine that does other things beside. And how soon an hour of them opens.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include <QFile>
#include <QTemporaryDir>

#include "core/base/random.h"
#include "core/link/recording_packing.h"
#include "core/link/recording_reader.h"
#include "tests/doubles/plain_recording.h"

namespace {

using namespace usar;
using namespace usar::link;
using Clock = std::chrono::steady_clock;

constexpr std::size_t batch_bytes = 1u << 20; ///< as RecordingWriter hands them over

struct Kept {
    Record record;
    std::string name;
    std::string bytes;
    Record view() const {
        Record copy = record;
        copy.name = name;
        copy.bytes = bytes;
        return copy;
    }
};

/// The first seconds of a flight again and again, every time with other last decimals: with the same ones they
/// would compress as no flight does.
std::vector<Kept> flight(std::size_t least_bytes, RecordTime pace) {
    const auto reader = *RecordingReader::open(USAR_SOURCE_DIR "/tests/data/recordings/version_1.usarrec");
    Random random = seeded(1, 1);
    std::uniform_int_distribution<int> digit('0', '9');
    std::vector<Kept> records;
    RecordTime time{0};
    for (std::size_t bytes = 0; bytes < least_bytes;) {
        const auto record = reader->next();
        if (!record) {
            reader->seek(RecordTime{0});
            continue;
        }
        Kept& kept = records.emplace_back(Kept{*record, std::string(record->name), std::string(record->bytes)});
        if (record->kind == RecordKind::End || record->kind == RecordKind::Opened)
            kept.record.kind = RecordKind::Note;
        kept.record.time = time += pace;
        for (std::size_t at = kept.bytes.find('.'); at != std::string::npos; at = kept.bytes.find('.', at + 1))
            for (const std::size_t i : {at + 3, at + 4}) // The last two of four; a time has one or two.
                if (i < kept.bytes.size() && kept.bytes[i] >= '0' && kept.bytes[i] <= '9')
                    kept.bytes[i] = static_cast<char>(digit(random));
        bytes += kept.bytes.size();
    }
    return records;
}

struct Written {
    double caller_s = 0.0; ///< of it, time in the thread that has the records
    double all_s = 0.0;
    std::size_t bytes = 0;
};

double since(Clock::time_point begin) {
    return Seconds(Clock::now() - begin).count();
}

/// Writes what is in `bytes` and empties it.
void hand(std::string& bytes, QFile& file, Written& written) {
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    written.bytes += bytes.size();
    bytes.clear();
}

Written writePlain(const std::vector<Kept>& records, const QString& path) {
    QFile file(path);
    file.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
    Written written;
    const auto begin = Clock::now();
    std::string bytes;
    doubles::appendOldHead(bytes);
    auto turn = Clock::now();
    for (const Kept& kept : records) {
        doubles::appendPlain(bytes, kept.view());
        if (bytes.size() < batch_bytes)
            continue;
        written.caller_s += since(turn);
        hand(bytes, file, written);
        turn = Clock::now();
    }
    written.caller_s += since(turn);
    hand(bytes, file, written);
    written.all_s = since(begin);
    return written;
}

Written writePacked(const std::vector<Kept>& records, const QString& path, std::size_t batch = batch_bytes) {
    QFile file(path);
    file.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
    Written written;
    const auto begin = Clock::now();
    std::string bytes;
    recording::appendHead(bytes);
    BlockWriter blocks(bytes.size());
    RecordPacker packer;
    auto turn = Clock::now();
    for (const Kept& kept : records) {
        packer.add(kept.view());
        if (packer.size() < batch)
            continue;
        written.caller_s += since(turn);
        blocks.append(bytes, packer.take());
        hand(bytes, file, written);
        turn = Clock::now();
    }
    written.caller_s += since(turn);
    blocks.append(bytes, packer.take());
    blocks.appendIndex(bytes);
    hand(bytes, file, written);
    written.all_s = since(begin);
    return written;
}

/// `size`: of version 1 to version 2. `session_time`, `all_time`: of version 2 to version 1, in the thread of the
/// session and in both threads together.
void recordsPackedAndPlain(benchmark::State& state) {
    const QTemporaryDir folder;
    const std::vector<Kept> records = flight(32u << 20, RecordTime{100'000});
    Written plain, packed;
    for (auto _ : state) {
        const Written one = writePlain(records, folder.filePath("plain.usarrec"));
        const Written other = writePacked(records, folder.filePath("packed.usarrec"));
        for (const auto& [sum, part] : {std::pair(&plain, &one), {&packed, &other}}) {
            sum->caller_s += part->caller_s;
            sum->all_s += part->all_s;
            sum->bytes = part->bytes;
        }
    }
    state.counters["size"] = static_cast<double>(plain.bytes) / static_cast<double>(packed.bytes);
    state.counters["session_time"] = packed.caller_s / plain.caller_s;
    state.counters["all_time"] = packed.all_s / plain.all_s;
    state.counters["MB_per_s"] =
        static_cast<double>(plain.bytes) * static_cast<double>(state.iterations()) / 1e6 / packed.all_s;
}
BENCHMARK(recordsPackedAndPlain)->Unit(benchmark::kMillisecond);

/// An hour of a robot. 0: version 1; 1: version 2 with its index; 2: without one, as after a crash; 3: with it, and
/// read for damage.
void openAnHour(benchmark::State& state) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("hour.usarrec");
    const std::vector<Kept> records = flight(150u << 20, RecordTime{10'000'000});
    state.range(0) == 0 ? writePlain(records, path) : writePacked(records, path);
    QFile file(path);
    if (state.range(0) == 2)
        file.resize(file.size() - 1);
    for (auto _ : state)
        benchmark::DoNotOptimize(
            RecordingReader::open(path, state.range(0) == 3 ? OpenMode::Thorough : OpenMode::Quick));
    state.counters["MB"] = static_cast<double>(file.size()) / 1e6;
}
BENCHMARK(openAnHour)->DenseRange(0, 3)->Unit(benchmark::kMicrosecond);

} // namespace
