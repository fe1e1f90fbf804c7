#include "core/campaign/comparison/campaign_figures.h"

#include <algorithm>
#include <map>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include "core/base/numbers.h"
#include "core/campaign/comparison/pairing.h"
#include "core/campaign/plan/manifest_head.h"
#include "core/campaign/runs/parallel.h"
#include "core/campaign/runs/shard_file.h"
#include "core/mission/files/small_picture.h"

namespace usar::campaign {

namespace {

constexpr const char* compared[] = {"duration_s", "distance_m", "coverage_pct", "reachable_coverage_pct",
                                    "rmse_m",     "charges",    "collisions"};

void addFacts(CampaignFigures& figures, const QJsonObject& head, const std::vector<RunResult>& results,
              const std::string& of) {
    const auto add = [&](const std::string& name, const std::string& value) {
        figures.facts.emplace_back(name + of, value);
    };
    add("version", head["version"].toString().toStdString());
    add("runs",
        std::to_string(results.size()) + " of " + std::to_string(static_cast<qint64>(head["runs"].toInteger())));
    double processor_s = 0.0;
    for (const RunResult& result : results)
        processor_s += result.summary.value("cpu_s").toDouble();
    add("processor time", fixed(processor_s, 1) + " s");
    for (const QJsonValue input : head["inputs"].toArray())
        add(input["role"].toString().toStdString() + " " + input["name"].toString().toStdString(),
            input["sha256"].toString().toStdString());
}

/// Returns what reports add to the names of variants: in parentheses, as much of the ends of the folders' paths as
/// tells two apart; nothing for a single folder.
Result<std::vector<std::string>> folderLabels(const QStringList& folders) {
    if (folders.size() < 2)
        return std::vector<std::string>(1);
    QStringList paths;
    for (const QString& folder : folders)
        paths << QDir::cleanPath(QFileInfo(folder).absoluteFilePath());
    if (QFileInfo::exists(paths[0]) && QFileInfo(paths[0]) == QFileInfo(paths[1]))
        return failure("the same campaign is given twice", folders[0].toStdString(),
                       "Give the folder once to compare its variants, or another campaign's beside it");
    const auto endOf = [](const QString& path, int parts) { return path.section('/', -parts); };
    int parts = 1;
    while (endOf(paths[0], parts) == endOf(paths[1], parts) && parts < paths[0].size())
        ++parts;
    std::vector<std::string> labels;
    for (const QString& path : paths)
        labels.push_back(" (" + endOf(path, parts).toStdString() + ')');
    return labels;
}

std::vector<QPointF> pointsIn(const QJsonValue& list) {
    std::vector<QPointF> points;
    for (const QJsonValue point : list.toArray())
        points.emplace_back(point[0].toDouble(), point[1].toDouble());
    return points;
}

/// Pairs of two campaigns can only be compared if they mean the same.
Result<void> checkPairs(const std::vector<RunResult>& first, const std::vector<RunResult>& second,
                        const QString& folder) {
    std::map<int, const RunResult*> known;
    for (const RunResult& result : first)
        known[result.pair] = &result;
    for (const RunResult& result : second) {
        const auto same = known.find(result.pair);
        if (same != known.end() && (same->second->mission != result.mission || same->second->seed != result.seed))
            return failure("the campaigns do not fly the same: pair " + std::to_string(result.pair) + " is " +
                               same->second->mission + " with seed " + std::to_string(same->second->seed) +
                               " in one and " + result.mission + " with seed " + std::to_string(result.seed) +
                               " in the other",
                           folder.toStdString(), "Compare campaigns with the same missions and seeds");
    }
    return {};
}

/// Looks for it in the campaign's folder, which may lie elsewhere than when the run was flown.
std::string pictureOf(const RunResult& result, const QString& folder) {
    for (const QJsonValue file : result.summary.value("files").toArray())
        if (const QString path = file.toString(); mission::isMapPicture(path))
            return QDir(runFolder(folder, result.number)).filePath(QFileInfo(path).fileName()).toStdString();
    return {};
}

/// Adds the runs and takes the summaries from the results, because nobody needs them any longer.
void addRuns(CampaignFigures& figures, std::vector<RunResult>& results, const QString& folder, const std::string& of) {
    const std::size_t first = figures.runs.size();
    figures.runs.resize(first + results.size());
    inParallel(results.size(), [&](std::size_t i) {
        figures.runs[first + i] = figuresOf(results[i]);
        figures.runs[first + i].variant += of;
        figures.runs[first + i].picture = pictureOf(results[i], folder);
        results[i].summary = {};
    });
}

} // namespace

std::vector<Candidate> candidatesFor(const std::string& baseline, const CampaignFigures& figures) {
    const auto second = figures.variants.begin() + static_cast<std::ptrdiff_t>(figures.of_first);
    const bool one_campaign = second == figures.variants.end();
    const bool of_first = std::find(figures.variants.begin(), second, baseline) != second;
    const auto begin = of_first && !one_campaign ? second : figures.variants.begin();
    const auto end = of_first || one_campaign ? figures.variants.end() : second;
    std::vector<Candidate> candidates;
    for (const std::string& variant : std::vector(begin, end)) {
        if (variant == baseline)
            continue;
        const auto pairs = pairUp(figures.runs, baseline, variant);
        candidates.push_back({variant, pairs ? std::nullopt : std::optional(pairs.error())});
    }
    return candidates;
}

QString missingRuns(const CampaignFigures& figures) {
    if (figures.runs.size() >= figures.planned)
        return {};
    const std::size_t missing = figures.planned - figures.runs.size();
    return QString("%1 of %2 runs %3 no result yet.")
        .arg(missing)
        .arg(figures.planned)
        .arg(missing == 1 ? "has" : "have");
}

RunFigures figuresOf(const RunResult& result) {
    RunFigures figures;
    figures.number = static_cast<std::size_t>(result.number);
    figures.pair = static_cast<std::size_t>(result.pair);
    figures.seed = result.seed;
    figures.mission = result.mission;
    figures.variant = result.variant;
    figures.outcome = result.outcome;
    figures.reason = result.reason;
    figures.command = result.command.toStdString();
    figures.time_limit_s = result.limit_s;
    for (const char* key : compared) {
        const QJsonValue value = result.summary.value(QLatin1String(key));
        figures.metrics[key] = value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
    }
    const QJsonObject course = result.summary.value("course").toObject();
    figures.course = {pointsIn(course["coverage"]), pointsIn(course["path"]), pointsIn(course["given_up"]),
                      pointsIn(course["collisions"])};
    return figures;
}

Result<CampaignFigures> readCampaigns(const QStringList& folders) {
    CampaignFigures figures;
    const auto labels = folderLabels(folders);
    if (!labels)
        return tl::unexpected(labels.error());
    std::vector<RunResult> first;
    for (const QString& folder : folders) {
        const auto head = readManifestHead(folder);
        if (!head)
            return tl::unexpected(head.error());
        auto results = readResults(folder, (*head)["version"].toString().toStdString());
        if (!results)
            return tl::unexpected(results.error());
        if (results->empty())
            return failure("there are no results yet", folder.toStdString(), "Fly the campaign first");
        if (auto same = checkPairs(first, *results, folder); !same)
            return tl::unexpected(same.error());
        const bool is_first = &folder == &folders.front();
        const std::string& of = is_first ? labels->front() : labels->back();
        figures.title += (figures.title.empty() ? "" : ", ") + (*head)["campaign"].toString().toStdString();
        for (const QJsonValue variant : (*head)["variants"].toArray())
            figures.variants.push_back(variant.toString().toStdString() + of);
        if (is_first)
            figures.of_first = figures.variants.size();
        figures.planned += static_cast<std::size_t>((*head)["runs"].toInteger());
        addFacts(figures, *head, *results, of);
        addRuns(figures, *results, folder, of);
        first = *std::move(results);
    }
    return figures;
}

} // namespace usar::campaign
