#include "core/campaign/comparison/report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::campaign {

namespace {

const QString dash = QStringLiteral("\u2013");

/// A hyphen is too short for a minus before a number; rounding to zero leaves no sign.
QString number(double value, int decimals, bool with_sign) {
    if (!std::isfinite(value))
        return dash;
    QString text = QString::fromStdString(fixed(std::abs(value), decimals));
    const bool is_zero = std::ranges::none_of(text, [](QChar one) { return one >= u'1' && one <= u'9'; });
    if (!is_zero && value < 0.0)
        text.prepend(QChar(0x2212));
    else if (!is_zero && with_sign)
        text.prepend('+');
    return text;
}

/// A difference of two percentages is not a percentage.
QString withUnit(const QString& text, const Metric& metric, bool is_difference) {
    if (metric.unit.empty() || text == dash)
        return text;
    return text + ' ' + (is_difference && metric.unit == "%" ? "points" : QString::fromStdString(metric.unit));
}

QString counted(std::size_t count, const QString& one, const QString& many) {
    return QString::number(count) + ' ' + (count == 1 ? one : many);
}

/// Up to two digits, because nobody knows more.
std::size_t rounded(std::size_t count) {
    std::size_t step = 1;
    while (count / step >= 100)
        step *= 10;
    return (count + step - 1) / step * step;
}

bool isAllowedInXml(QChar c) {
    return c == '\t' || c == '\n' || c == '\r' || (c >= QChar(0x20) && c < QChar(0xfffe));
}

} // namespace

QString headline(const Comparison& comparison) {
    const QString baseline = nameOf(comparison.baseline), candidate = nameOf(comparison.candidate);
    switch (comparison.overall) {
    case Verdict::Better:
        return candidate + " is better than " + baseline;
    case Verdict::Worse:
        return candidate + " is worse than " + baseline;
    case Verdict::Equal:
        return candidate + " is equal to " + baseline;
    case Verdict::NotWorse:
        return candidate + " is not worse than " + baseline;
    case Verdict::Undecided:
        break;
    }
    return "Whether " + candidate + " is worse than " + baseline + " is undecided";
}

QString outlook(const std::optional<std::size_t>& more_seeds) {
    if (!more_seeds)
        return "more seeds are unlikely to decide";
    if (*more_seeds == 0)
        return {};
    return "about " + counted(rounded(*more_seeds), "more seed", "more seeds") + " would decide";
}

std::vector<QString> omissions(const Comparison& comparison) {
    std::vector<QString> sentences = restrictedMeans(comparison);
    const Pairing& pairing = comparison.pairing;
    if (pairing.single > 0)
        sentences.push_back(counted(pairing.single, "run has", "runs have") + " no partner of the same seed.");
    if (pairing.not_counted > 0)
        sentences.push_back(counted(pairing.not_counted, "pair is", "pairs are") +
                            " not counted, because a run was refused or killed.");
    if (pairing.repeated > 0)
        sentences.push_back(counted(pairing.repeated, "run repeats", "runs repeat") +
                            " a seed of its variant, and only the first of each counts.");
    std::map<std::size_t, std::vector<std::string>> titles_by_left_out;
    for (const MetricComparison& metric : comparison.metrics)
        if (metric.values.left_out > 0)
            titles_by_left_out[metric.values.left_out].push_back(metric.metric.title);
    for (const auto& [left_out, titles] : titles_by_left_out)
        sentences.push_back(counted(left_out, "pair is", "pairs are") + " left out of " +
                            QString::fromStdString(listOf(titles)) +
                            ", because a run has no such figure or was not done.");
    return sentences;
}

QString restrictionOf(const MetricComparison& result) {
    const Interval limits = result.values.limits.value_or(Interval{});
    return limits.low == limits.high ? "to " + amount(limits.high, result.metric) : QString("to their limits");
}

std::vector<QString> restrictedMeans(const Comparison& comparison) {
    std::vector<QString> sentences;
    for (const MetricComparison& result : comparison.metrics) {
        if (!result.baseline_restricted || !result.candidate_restricted)
            continue;
        const auto side = [&](const std::string& variant, double mean, std::size_t unfinished) {
            return QString("%1 %2 with %3 not done")
                .arg(nameOf(variant), amount(mean, result.metric), counted(unfinished, "run", "runs"));
        };
        QString sentence = QString::fromStdString(result.metric.title) + ", mean " + restrictionOf(result) + ": " +
                           side(comparison.baseline, *result.baseline_restricted, result.baseline_unfinished) + ", " +
                           side(comparison.candidate, *result.candidate_restricted, result.candidate_unfinished) + '.';
        if (result.values.assumed > 0)
            sentence += " " + counted(result.values.assumed, "run", "runs") +
                        " not done without a time limit counted the longest time of any run of the mission.";
        sentences.push_back(sentence);
    }
    return sentences;
}

QString seedOf(const RunFigures& run, const Comparison& comparison) {
    const QString seed = QString::number(run.seed);
    return comparison.pairing.missions.size() > 1 ? seed + " of " + nameOf(run.mission) : seed;
}

std::vector<QString> differingSeeds(const Comparison& comparison) {
    constexpr qsizetype most = 20;
    QStringList of_baseline, of_candidate;
    for (const RunPair& pair : comparison.success.differing)
        (pair.baseline->outcome == Outcome::Done ? of_baseline : of_candidate) << seedOf(*pair.baseline, comparison);
    std::vector<QString> sentences;
    for (const auto& [seeds, variant] :
         {std::pair(of_baseline, comparison.baseline), std::pair(of_candidate, comparison.candidate)}) {
        if (seeds.isEmpty())
            continue;
        const auto count = static_cast<std::size_t>(seeds.size());
        sentences.push_back("Only " + nameOf(variant) + " has success on " + counted(count, "seed", "seeds") + ": " +
                            seeds.first(std::min(most, seeds.size())).join(", ") +
                            (seeds.size() > most ? QString(" and %1 more.").arg(seeds.size() - most) : QString(".")));
    }
    return sentences;
}

QString amount(double value, const Metric& metric, bool is_difference) {
    return withUnit(number(value, metric.decimals, is_difference), metric, is_difference);
}

QString amount(const Interval& interval, const Metric& metric) {
    return number(interval.low, metric.decimals, true) + " to " + amount(interval.high, metric, true);
}

QString amount(const Count& count) {
    return QString("%1 of %2, %3 %").arg(count.successes).arg(count.trials).arg(percent(count.rate()));
}

QString percent(double share, bool with_sign) {
    return number(100.0 * share, 1, with_sign);
}

QString pValue(double p) {
    return p < 0.001 ? QString("< 0.001") : number(p, 3, false);
}

QString plain(double value) {
    return number(value, 2, false);
}

QString printable(const std::string& text) {
    QString result;
    for (const QChar c : QString::fromStdString(text))
        if (isAllowedInXml(c))
            result += c;
    return result;
}

QString nameOf(const std::string& name) {
    return name.empty() ? QString("(no name)") : printable(name);
}

} // namespace usar::campaign
