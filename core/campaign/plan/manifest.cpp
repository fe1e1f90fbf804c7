#include "core/campaign/plan/manifest.h"

#include <array>
#include <charconv>

#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include "core/mission/files/scan_record.h"
#include "core/mission/reports/json_line.h"

namespace usar::campaign {

namespace {

Error unreadable(const QFile& file) {
    return {"cannot read it: " + file.errorString().toStdString(), file.fileName().toStdString(),
            "Check the name and the permissions"};
}

Result<void> addFile(const QString& path, QCryptographicHash& hash) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return tl::unexpected(unreadable(file));
    return {};
}

QStringList filesIn(const QString& folder) {
    QStringList files;
    QDirIterator walk(folder, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext())
        files << walk.next();
    files.sort();
    return files;
}

QJsonArray textsOf(const std::vector<std::string>& texts) {
    return QJsonArray::fromStringList(mission::textsOf(texts));
}

/// Each text in quotes, as JSON has it.
std::vector<QByteArray> quoted(const std::vector<std::string>& texts) {
    std::vector<QByteArray> all;
    for (const std::string& text : texts) {
        const QByteArray list = QJsonDocument(QJsonArray{QString::fromStdString(text)}).toJson(QJsonDocument::Compact);
        all.push_back(list.sliced(1, list.size() - 2));
    }
    return all;
}

/// Writes the lines of runs. What many of them share is turned into JSON once: a manifest may have a hundred thousand,
/// and is written again to be compared when its campaign goes on.
class RunLines {
public:
    RunLines(const Manifest& manifest, const Campaign& campaign)
        : missions_(quoted(manifest.missions))
        , variants_(quoted(manifest.variants)) {
        std::vector<std::string> behaviors;
        for (const Variant& variant : campaign.variants)
            behaviors.push_back(variant.behavior);
        behaviors_ = quoted(behaviors);
    }

    /// The keys are in the order of the alphabet, as in all our JSON.
    void append(const PlannedRun& run, QByteArray& text) const {
        text += "{\"behavior\":";
        text += behaviors_[run.variant];
        text += ",\"faults\":";
        appendList(run.faults, text);
        text += ",\"mission\":";
        text += missions_[run.mission];
        text += ",\"pair\":";
        appendNumber(run.pair, text);
        text += ",\"run\":";
        appendNumber(run.number, text);
        text += ",\"seed\":";
        appendNumber(static_cast<qint64>(run.seed), text);
        text += ",\"values\":";
        appendList(run.values, text);
        text += ",\"variant\":";
        text += variants_[run.variant];
        text += "}\n";
    }

private:
    // Everything is appended to the whole text, because a manifest may have a hundred thousand lines.
    static void appendList(const std::vector<std::string>& texts, QByteArray& text) {
        if (texts.empty())
            text += "[]";
        else
            text += QJsonDocument(textsOf(texts)).toJson(QJsonDocument::Compact);
    }

    static void appendNumber(qint64 number, QByteArray& text) {
        std::array<char, 24> digits{};
        const auto [end, problem] = std::to_chars(digits.begin(), digits.end(), number);
        text.append(digits.data(), end - digits.data());
    }

    std::vector<QByteArray> missions_;
    std::vector<QByteArray> variants_;
    std::vector<QByteArray> behaviors_; ///< They are in the order of the variants.
};

/// Says what is not the same in two first lines.
std::string differenceOf(const QJsonObject& old_head, const QJsonObject& new_head) {
    for (const auto& [key, words] :
         {std::pair("campaign", "name"), std::pair("version", "version of the program"),
          std::pair("limit_h", "limit of simulated time"), std::pair("wall_limit_s", "limit of wall time"),
          std::pair("runs", "number of runs")})
        if (old_head[key] != new_head[key])
            return std::string("its ") + words + " is another one";
    const QJsonArray before = old_head["inputs"].toArray();
    for (const QJsonValue input : new_head["inputs"].toArray())
        if (!before.contains(input))
            return "the " + input["role"].toString().toStdString() + " " + input["name"].toString().toStdString() +
                   " is not what it was";
    return "the campaign's runs are not the same";
}

QJsonObject headOf(const QByteArray& text) {
    return QJsonDocument::fromJson(text.left(text.indexOf('\n'))).object();
}

} // namespace

Result<HashedInput> hashInput(const QString& role, const QString& name, const QString& path) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const bool is_folder = QDir(path).exists();
    for (const QString& file : is_folder ? filesIn(path) : QStringList{path}) {
        if (is_folder)
            hash.addData((QDir(path).relativeFilePath(file) + '\n').toUtf8());
        if (const auto added = addFile(file, hash); !added)
            return tl::unexpected(added.error());
    }
    return HashedInput{role, name, hash.result().toHex()};
}

QByteArray toText(const Manifest& manifest, const Campaign& campaign) {
    QJsonArray inputs;
    for (const HashedInput& input : manifest.inputs)
        inputs << QJsonObject{
            {"role", input.role}, {"name", input.name}, {"sha256", QString::fromLatin1(input.sha256_hex)}};
    QByteArray text =
        mission::jsonLine({{"campaign", QString::fromStdString(manifest.campaign)},
                           {"version", QString::fromStdString(manifest.version)},
                           {"missions", textsOf(manifest.missions)},
                           {"variants", textsOf(manifest.variants)},
                           {"limit_h", campaign.limit_h ? QJsonValue(*campaign.limit_h) : QJsonValue::Null},
                           {"wall_limit_s", campaign.wall_limit_s},
                           {"runs", static_cast<qint64>(manifest.runs.size())},
                           {"inputs", inputs}});
    const RunLines lines(manifest, campaign);
    for (const PlannedRun& run : manifest.runs)
        lines.append(run, text);
    return text;
}

Result<void> keepManifest(const QByteArray& text, const QString& folder) {
    if (!QDir().mkpath(folder))
        return failure("the folder cannot be made", folder.toStdString(), "Give another one with --out");
    const QString path = QDir(folder).filePath(manifest_file);
    QFile old_file(path);
    if (old_file.open(QIODevice::ReadOnly)) {
        const QByteArray old_text = old_file.readAll();
        if (old_text == text)
            return {};
        return failure("the folder holds the results of another campaign: " +
                           differenceOf(headOf(old_text), headOf(text)),
                       path.toStdString(), "Give another folder with --out");
    }
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit())
        return {};
    return failure("the manifest cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                   "Make room, or give another folder with --out");
}

} // namespace usar::campaign
