#include "core/link/recording_convert.h"

#include <string>

#include "core/base/text.h"
#include "core/link/recording_reader.h"
#include "core/link/recording_text.h"

namespace usar::link {

namespace {

constexpr std::size_t chunk_bytes = 1u << 20;

Result<void> hand(std::string& batch, QIODevice& to) {
    if (to.write(batch.data(), static_cast<qint64>(batch.size())) != static_cast<qint64>(batch.size()))
        return failure("writing failed: " + to.errorString().toStdString(), "the output",
                       "Is there room left, and does somebody read it");
    batch.clear();
    return {};
}

std::string_view withoutEnd(const QByteArray& line) {
    std::string_view text(line.constData(), static_cast<std::size_t>(line.size()));
    while (text.ends_with('\n') || text.ends_with('\r'))
        text.remove_suffix(1);
    return text;
}

} // namespace

Result<void> recordingToText(const QString& recording_path, QIODevice& text) {
    const auto reader = RecordingReader::open(recording_path);
    if (!reader)
        return tl::unexpected(reader.error());
    std::string batch(recording::text_title);
    batch += '\n';
    auto damage = (*reader)->survey().damage.begin();
    const auto damage_end = (*reader)->survey().damage.end();
    const auto noteDamage = [&](std::uint64_t before) {
        for (; damage != damage_end && damage->offset < before; ++damage)
            batch += "# " + std::to_string(damage->bytes) + " damaged bytes at byte " + std::to_string(damage->offset) +
                     "\n";
    };
    while (const auto record = (*reader)->next()) {
        noteDamage((*reader)->offset());
        recording::appendText(batch, *record);
        if (batch.size() < chunk_bytes)
            continue;
        if (auto handed = hand(batch, text); !handed)
            return handed;
    }
    noteDamage(UINT64_MAX);
    return hand(batch, text);
}

Result<void> textToRecording(QIODevice& text, const QString& text_name, QIODevice& recording) {
    const auto at = [&](std::uint64_t line) { return text_name.toStdString() + ", line " + std::to_string(line); };
    if (withoutEnd(text.readLine()) != recording::text_title)
        return failure("this is not the text form of a recording", at(1),
                       "Its first line must be \"" + std::string(recording::text_title) + "\"");
    std::string batch;
    recording::appendHead(batch);
    recording::TextRecord reader;
    for (std::uint64_t number = 2;; ++number) {
        const QByteArray bytes = text.readLine();
        if (bytes.isEmpty()) // Unlike atEnd(), which a pipe reports too early.
            return hand(batch, recording);
        const std::string_view line = withoutEnd(bytes);
        if (trimmed(line).empty() || line.starts_with('#'))
            continue;
        const auto record = reader.read(line);
        if (!record)
            return failure(record.error().what, at(number) + ", " + record.error().where, record.error().mend);
        recording::append(batch, *record);
        if (batch.size() < chunk_bytes)
            continue;
        if (auto handed = hand(batch, recording); !handed)
            return handed;
    }
}

} // namespace usar::link
