#include <algorithm>
#include <cmath>

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "core/campaign/comparison/html_report.h"
#include "core/campaign/comparison/json_report.h"
#include "core/campaign/comparison/junit_report.h"
#include "core/campaign/comparison/single_report.h"
#include "core/campaign/comparison/svg_canvas.h"
#include "core/campaign/comparison/text_report.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_comparison_reports {

using namespace usar::campaign;
using usar::test::doneRuns;
using usar::test::run;
using enum Outcome;

namespace {

const std::string nasty = "<script>alert('a' & \"b\")</script>\x01\x1b[31m \xc3\xa4 \xef\xbf\xbf";
const QString nasty_shown = QString::fromUtf8("<script>alert('a' & \"b\")</script>[31m \xc3\xa4 ");

std::vector<RunFigures> runsWithFailures() {
    std::vector<RunFigures> runs = doneRuns(40, {-10.0});
    for (RunFigures& figures : runs)
        if (figures.variant == "new" && figures.pair % 8 == 0) {
            figures.outcome = Failed;
            figures.reason = nasty;
        }
    return runs;
}

/// The third variant is as the new one.
std::vector<RunFigures> threeVariants() {
    std::vector<RunFigures> runs = doneRuns(30, {-10.0});
    for (std::size_t i = 0; i < 60; ++i)
        if (runs[i].variant == "new") {
            RunFigures third = runs[i];
            third.variant = "third";
            runs.push_back(third);
        }
    return runs;
}

struct Element {
    QString name;
    QXmlStreamAttributes attributes;
    QString text;
};

/// All elements with the text that follows their start. Empty if the bytes are not well-formed.
std::vector<Element> elementsOf(const QByteArray& bytes) {
    std::vector<Element> elements;
    QXmlStreamReader xml(bytes);
    bool follows_start = false;
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        if (token == QXmlStreamReader::StartElement)
            elements.push_back({xml.name().toString(), xml.attributes(), {}});
        else if (token == QXmlStreamReader::Characters && follows_start)
            elements.back().text += xml.text();
        follows_start =
            token == QXmlStreamReader::StartElement || (follows_start && token == QXmlStreamReader::Characters);
    }
    return xml.hasError() ? std::vector<Element>() : elements;
}

int countOf(const std::vector<Element>& elements, const QString& name) {
    return static_cast<int>(
        std::count_if(elements.begin(), elements.end(), [&](const Element& e) { return e.name == name; }));
}

int countOfClass(const std::vector<Element>& elements, const QString& style_class) {
    return static_cast<int>(std::count_if(elements.begin(), elements.end(), [&](const Element& e) {
        return e.attributes.value("class") == style_class;
    }));
}

bool says(const std::vector<Element>& elements, const QString& name, const QString& text) {
    return std::any_of(elements.begin(), elements.end(),
                       [&](const Element& e) { return e.name == name && e.text == text; });
}

} // namespace

class tst_ComparisonReports : public QObject {
    Q_OBJECT
private slots:
    void wordsOfOthersLoseWhatATerminalWouldObey() {
        QCOMPARE(printable(nasty), nasty_shown);
        QCOMPARE(nameOf(""), QString("(no name)"));
    }

    void amountsHaveTheirUnitAndSign_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("amount_text");
        QTest::addColumn<QString>("difference_text");
        QTest::newRow("seconds") << 12.34 << "s"
                                 << "12.3 s"
                                 << "+12.3 s";
        QTest::newRow("less") << -12.34 << "s" << u8"−12.3 s" << u8"−12.3 s";
        QTest::newRow("percentages differ by points") << 1.0 << "%"
                                                      << "1.0 %"
                                                      << "+1.0 points";
        QTest::newRow("rounded to zero") << -0.04 << ""
                                         << "0.0"
                                         << "0.0";
        QTest::newRow("not known") << std::nan("") << "s" << u8"–" << u8"–";
    }
    void amountsHaveTheirUnitAndSign() {
        QFETCH(double, value);
        QFETCH(QString, unit);
        Metric metric;
        metric.unit = unit.toStdString();
        metric.decimals = 1;
        QTEST(amount(value, metric), "amount_text");
        QTEST(amount(value, metric, true), "difference_text");
    }

    void coursesAreDrawnOfRunsThatTellThem() {
        QTest::failOnWarning(QRegularExpression(".")); // Nobody kept a map of them, so no file is opened.
        std::vector<RunFigures> runs = doneRuns(20, {-10.0});
        const auto drawn = [&] {
            const Comparison comparison = compare(runs, "old", "new").value();
            return elementsOf(htmlReport({comparison, runs, "Courses", {}}));
        };
        const QString coverage = "Coverage of quick_scan over time";
        const QString places = "Where runs of quick_scan collided or gave goals up";
        auto elements = drawn();
        QVERIFY(!elements.empty());
        QVERIFY(!says(elements, "h2", coverage) && !says(elements, "h2", places));
        QCOMPARE(countOfClass(elements, "course"), 0);
        for (RunFigures& figures : runs)
            figures.course = {{{0.0, 0.0}, {100.0, 99.0}}, {{0.0, 0.0}, {10.0, 5.0}}, {}, {}};
        elements = drawn();
        QVERIFY(says(elements, "h2", coverage) && !says(elements, "h2", places));
        QCOMPARE(countOfClass(elements, "spread baseline"), 1);
        QCOMPARE(countOfClass(elements, "course"), 10); // the worst runs
        runs[3].course.given_up = {{2.0, 2.0}};
        runs[3].course.collisions = {{3.0, 3.0}, {4.0, 4.0}};
        elements = drawn();
        QVERIFY(says(elements, "h2", places));
        QCOMPARE(runs[3].variant, "new");
        QCOMPARE(countOfClass(elements, "given-up candidate"), 1 + 1); // The legend has one, too.
        QCOMPARE(countOfClass(elements, "given-up baseline"), 1);
        QCOMPARE(countOfClass(elements, "collision candidate"), 2 * (1 + 2)); // A cross has two lines.
    }

    void aRunWhoseMapWasKeptIsShownByItsPicture() {
        const QTemporaryDir folder;
        QImage map(1000, 500, QImage::Format_RGB32);
        map.fill(Qt::darkGreen);
        QVERIFY(map.save(folder.filePath("map.png")));
        std::vector<RunFigures> runs = doneRuns(20, {-10.0});
        for (RunFigures& figures : runs) {
            figures.course.path = {{0.0, 0.0}, {10.0, 5.0}};
            figures.picture = folder.filePath(figures.variant == "new" ? "map.png" : "gone.png").toStdString();
        }
        runs[1].outcome = Failed; // So it is among the worst.
        const Comparison comparison = compare(runs, "old", "new").value();
        const auto elements = elementsOf(htmlReport({comparison, runs, "Maps", {}}));
        const int maps = countOfClass(elements, "map");
        QVERIFY(maps > 0);
        QCOMPARE(maps + countOfClass(elements, "course"), 10 + 1); // The worst, and the one that failed alone.
        const auto shown = std::ranges::find_if(elements, [](const Element& one) { return one.name == "img"; });
        const QByteArray source = shown->attributes.value("src").toUtf8();
        QVERIFY(source.startsWith("data:image/png;base64,"));
        const QImage small = QImage::fromData(QByteArray::fromBase64(source.mid(source.indexOf(',') + 1)));
        QCOMPARE(small.size(), QSize(480, 240));
    }

    void theOutlookIsNoMoreExactThanAnybodyKnows() {
        QCOMPARE(outlook(0), QString());
        QCOMPARE(outlook(1), QString("about 1 more seed would decide"));
        QCOMPARE(outlook(99), QString("about 99 more seeds would decide"));
        QCOMPARE(outlook(1501), QString("about 1600 more seeds would decide"));
        QCOMPARE(outlook(std::nullopt), QString("more seeds are unlikely to decide"));
    }

    void theTextHasAVerdictForEachQuestion() {
        const std::vector<RunFigures> runs = doneRuns(100, {-10.0});
        const QString text = textReport(compare(runs, "old", "new").value());
        QVERIFY(text.startsWith("new is better than old.\n\n"));
        const QStringList lines = text.split('\n');
        const QStringList duration = lines.filter(QRegularExpression("^Duration"));
        QCOMPARE(duration.size(), 1);
        QVERIFY2(duration[0].contains(QRegularExpression(u8"better +\\d+\\.\\d s +\\d+\\.\\d s +−\\d+\\.\\d s IQM")),
                 qPrintable(duration[0]));
        QVERIFY(!lines.filter(QRegularExpression("^Success +equal +100 of 100, 100.0 %")).empty());
        for (const QString& line : lines)
            QVERIFY(!line.endsWith(' '));
    }

    void theTextSaysWhatWasNotCompared() {
        std::vector<RunFigures> runs = runsWithFailures();
        runs.pop_back();
        runs.push_back(runs.front());
        runs[2].outcome = Refused;
        const QString text = textReport(compare(runs, "old", "new").value());
        QVERIFY(text.contains("1 run has no partner of the same seed."));
        QVERIFY(text.contains("1 pair is not counted, because a run was refused or killed."));
        QVERIFY(text.contains("1 run repeats a seed of its variant, and only the first of each counts."));
        QVERIFY(text.contains("5 pairs are left out of Way, "));
        QVERIFY2(text.contains("Only old has success on 5 seeds: 0, 8, 16, 24, 32.\n"), qPrintable(text));
        QVERIFY(!text.contains("Only new"));
    }

    void whatIsNotDoneIsInTheRestrictedMeans() {
        std::vector<RunFigures> runs = runsWithFailures();
        for (RunFigures& figures : runs)
            figures.metrics["duration_s"] = figures.variant == "new" ? 90.0 : 100.0;
        Comparison comparison = compare(runs, "old", "new").value();
        const QString means =
            "Duration, mean to 300.0 s: old 100.0 s with 0 runs not done, new 116.2 s with 5 runs not done.";
        QVERIFY2(textReport(comparison).contains(means + '\n'), qPrintable(textReport(comparison)));
        const QJsonArray metrics = jsonReport({comparison, runs, "", {}})["metrics"].toArray();
        QCOMPARE(metrics[0]["baseline_restricted_mean"].toDouble(), 100.0);
        QCOMPARE(metrics[0]["candidate_restricted_mean"].toDouble(), (35 * 90.0 + 5 * 300.0) / 40.0);
        QVERIFY(metrics[1]["candidate_restricted_mean"].isNull()); // The way is left out.
        QVERIFY(says(elementsOf(htmlReport({comparison, runs, "", {}})), "div", "mean to 300.0 s: 116.2 s"));

        for (RunFigures& figures : runs)
            figures.time_limit_s = std::nullopt;
        comparison = compare(runs, "old", "new").value();
        QVERIFY(textReport(comparison).contains("mean to 100.0 s: old 100.0 s with 0 runs"));
        QVERIFY(
            textReport(comparison)
                .contains(" 5 runs not done without a time limit counted the longest time of any run of the mission."));
        const std::vector<RunFigures> done = doneRuns(20, {});
        QVERIFY(restrictedMeans(compare(done, "old", "new").value()).empty());
    }

    void theShareOfSeedsIsShownForAVariantThatNeverSucceeds_data() {
        QTest::addColumn<bool>("old_fails");
        QTest::addColumn<bool>("new_fails");
        QTest::addColumn<int>("headings");
        QTest::newRow("both succeed") << false << false << 1;
        QTest::newRow("one never succeeds") << false << true << 1;
        QTest::newRow("the other never succeeds") << true << false << 1;
        QTest::newRow("neither does") << true << true << 0;
    }
    void theShareOfSeedsIsShownForAVariantThatNeverSucceeds() {
        QFETCH(bool, old_fails);
        QFETCH(bool, new_fails);
        std::vector<RunFigures> runs = doneRuns(12, {});
        for (RunFigures& figures : runs)
            if (figures.variant == "new" ? new_fails : old_fails)
                figures.outcome = Failed;
        const std::vector<Element> elements =
            elementsOf(htmlReport({compare(runs, "old", "new").value(), runs, "", {}}));
        const bool heading = says(elements, "h2", "Share of the seeds that are done by each time");
        QTEST(heading ? 1 : 0, "headings");
        QCOMPARE(std::ranges::count_if(elements,
                                       [](const Element& one) {
                                           return one.attributes.value("aria-label") ==
                                                  QString("share of seeds by Duration");
                                       }),
                 heading ? 1 : 0);
    }

    void aSingleVariantHasAPageWithoutVerdicts() {
        std::vector<RunFigures> runs;
        for (const RunFigures& figures : runsWithFailures())
            if (figures.variant == "new")
                runs.push_back(figures);
        const SingleReport single{runs, "thesis", {{"Version", "1.2"}}};
        const std::vector<Element> elements = elementsOf(htmlReport(single));
        QVERIFY(says(elements, "h1", "new: 35 of 40, 87.5 % done."));
        QVERIFY(says(elements, "p", "The campaign has one variant, new, so there is nothing to compare it with."));
        QVERIFY(says(elements, "td", nasty_shown)); // why runs failed
        QVERIFY(says(elements, "td", "1.2"));
        QVERIFY(says(elements, "h2", "Share of the seeds that are done by each time"));
        QVERIFY(!says(elements, "h2", "Verdicts"));
        QVERIFY2(textReport(single).contains("\nDone: 35 of 40, 87.5 % (95 %: 73.9 to 94.5 %).\nDuration: median "),
                 qPrintable(textReport(single)));
        const QJsonObject json = jsonReport(single);
        QCOMPARE(json["exit_code"].toInt(-1), 0);
        QCOMPARE(json["done"].toInt(), 35);
        QCOMPARE(json["metrics"][0]["key"].toString(), QString("duration_s"));
        runs.front().outcome = Killed;
        QVERIFY(textReport(single).endsWith("1 of 40 runs do not count, because they were refused or killed.\n"));
    }

    void theSeedsThatDifferAreNamed() {
        std::vector<RunFigures> runs = doneRuns(100, {});
        for (RunFigures& figures : runs)
            if ((figures.variant == "new" && figures.pair == 7) || (figures.variant == "old" && figures.pair % 4 == 1))
                figures.outcome = Failed;
        const std::vector<QString> sentences = differingSeeds(compare(runs, "old", "new").value());
        QCOMPARE(sentences.size(), std::size_t(2));
        QCOMPARE(sentences[0], QString("Only old has success on 1 seed: 7."));
        QVERIFY(sentences[1].startsWith("Only new has success on 25 seeds: 1, 5, 9, "));
        QVERIFY(sentences[1].endsWith(", 77 and 5 more."));
        for (RunFigures& figures : runs)
            if (figures.pair < 10)
                figures.mission = "tall_test";
        QCOMPARE(differingSeeds(compare(runs, "old", "new").value())[0],
                 QString("Only old has success on 1 seed: 7 of tall_test."));
    }

    void theJsonHasTheFigures() {
        const std::vector<RunFigures> runs = runsWithFailures();
        const Comparison comparison = compare(runs, "old", "new").value();
        const QJsonObject json = jsonReport({comparison, runs, "thesis", {{"Version", "1.2"}}});
        QCOMPARE(json["exit_code"].toInt(-1), comparison.exitCode());
        QCOMPARE(json["title"].toString(), QString("thesis"));
        QCOMPARE(json["pairs"].toInt(), 40);
        QCOMPARE(json["success"]["candidate"]["successes"].toInt(), 35);
        QCOMPARE(json["success"]["differing"].toArray().size(), 5);
        QCOMPARE(json["success"]["differing"][1]["seed"].toInt(), 8);
        QCOMPARE(json["facts"]["Version"].toString(), QString("1.2"));
        const QJsonArray metrics = json["metrics"].toArray();
        QCOMPARE(metrics.size(), static_cast<qsizetype>(comparison.metrics.size()));
        QCOMPARE(metrics[0]["key"].toString(), QString("duration_s"));
        QCOMPARE(metrics[0]["low"].toDouble(), comparison.metrics[0].interval.low);
        QCOMPARE(metrics[0]["candidate_unfinished"].toInt(), 5);
        QCOMPARE(metrics[2]["key"].toString(), QString("coverage_pct"));
        QVERIFY(metrics[2]["correlation"].isNull()); // a coverage that is always the same has none
    }

    void whatHasNoIntervalIsNullInJson() {
        const std::vector<RunFigures> runs = doneRuns(1, {});
        const QJsonObject json = jsonReport({compare(runs, "old", "new").value(), runs, "", {}});
        QVERIFY(json["metrics"][0]["low"].isNull());
        QVERIFY(json["more_seeds"].isNull());
    }

    void junitHasOneCaseForEachRun() {
        const std::vector<RunFigures> runs{run("old", 1),         run("old", 2, Failed),  run("new", 1, Crashed),
                                           run("new", 2, Killed), run("new", 3, Refused), run("new", 4, TimedOut)};
        const std::vector<Element> elements = elementsOf(junitReport(runs, "thesis"));
        QCOMPARE(countOf(elements, "testsuite"), 2);
        QCOMPARE(countOf(elements, "testcase"), 6);
        QCOMPARE(countOf(elements, "failure"), 1);
        QCOMPARE(countOf(elements, "error"), 3);
        QCOMPARE(countOf(elements, "skipped"), 1);
        const Element& suite = *std::find_if(elements.begin(), elements.end(), [](const Element& e) {
            return e.name == "testsuite" && e.attributes.value("name") == QString("new");
        });
        QCOMPARE(suite.attributes.value("tests").toInt(), 4);
        QCOMPARE(suite.attributes.value("errors").toInt(), 3);
        QCOMPARE(suite.attributes.value("failures").toInt(), 0);
        QCOMPARE(suite.attributes.value("skipped").toInt(), 1);
        QVERIFY(says(elements, "failure", "usar-mission run quick_scan.json --seed 2"));
    }

    void aCaseIsNamedByItsSeed() {
        std::vector<RunFigures> runs{run("old", 1), run("old", 2), run("old", 3)};
        runs[0].seed = 22;
        runs[1].seed = runs[2].seed = 23; // in two worlds
        QStringList names;
        for (const Element& element : elementsOf(junitReport(runs, "thesis")))
            if (element.name == "testcase")
                names << element.attributes.value("name").toString();
        QCOMPARE(names, (QStringList{"seed 22", "seed 23, pair 2", "seed 23, pair 3"}));
    }

    void junitTakesAnyWords() {
        std::vector<RunFigures> runs{run("old", 1, Failed)};
        runs[0].reason = runs[0].command = runs[0].mission = runs[0].variant = nasty;
        const std::vector<Element> elements = elementsOf(junitReport(runs, nasty));
        QCOMPARE(elements.size(), std::size_t{4});
        QCOMPARE(elements[0].attributes.value("name").toString(), nasty_shown);
        QCOMPARE(elements[3].attributes.value("message").toString(), nasty_shown);
        QCOMPARE(elements[3].text, nasty_shown);
    }

    void thePageIsWellFormedAndNeedsNothingElse() {
        const std::vector<RunFigures> runs = runsWithFailures();
        const QByteArray page = htmlReport({compare(runs, "old", "new").value(), runs, nasty, {{nasty, nasty}}});
        QVERIFY(page.startsWith("<!DOCTYPE html>"));
        const std::vector<Element> elements = elementsOf(page);
        QVERIFY(!elements.empty());
        for (const char* name : {"script", "link", "img", "iframe", "object", "image", "use"})
            QCOMPARE(countOf(elements, name), 0);
        for (const char* outside : {"http:", "https:", "url(", "@import", "src="})
            QVERIFY2(!page.contains(outside), outside);
        QVERIFY(says(elements, "td", nasty_shown));
        QVERIFY(page.contains("prefers-color-scheme: dark") && page.contains("@media print"));
        // What a style sheet escapes as XML, a browser would not read back.
        const QByteArray style = page.mid(page.indexOf("<style>"), page.indexOf("</style>") - page.indexOf("<style>"));
        QVERIFY(!style.contains('&'));
        QVERIFY(!page.contains("nan") && !page.contains("inf\""));
    }

    void thePageShowsEachPartOfTheComparison() {
        const std::vector<RunFigures> runs = runsWithFailures();
        const Comparison comparison = compare(runs, "old", "new").value();
        const QByteArray page = htmlReport({comparison, runs, "thesis", {{"Version", "1.2"}}});
        const std::vector<Element> elements = elementsOf(page);
        QVERIFY(says(elements, "h1", headline(comparison) + '.'));
        QVERIFY(page.contains("<span>quick_scan.json</span> <span>--seed</span> <span>8</span></code>"));
        QVERIFY(says(elements, "td", "1.2"));
        // Three metrics are the same in all pairs: coverage, charges and collisions. The way is, too, where it counts.
        const int metrics = static_cast<int>(comparison.metrics.size()), plots = countOf(elements, "figure");
        QCOMPARE(plots, 2 + 2); // and time against error and coverage
        // One interval for success and each metric, and one profile.
        QCOMPARE(countOf(elements, "svg"), 1 + metrics + plots + 1);
        QCOMPARE(countOf(elements, "path"), 2);
    }

    void severalCandidatesAreOnOnePage() {
        const std::vector<RunFigures> runs = threeVariants();
        const std::vector<Comparison> all = compareAll(runs, "old", {"new", "third"}).value();
        const std::vector<Element> elements =
            elementsOf(htmlReport(CampaignReport{all, runs, "thesis", {{"Version", "1"}}}));
        QVERIFY(says(elements, "h1", "2 variants against old."));
        for (std::size_t i = 0; i < all.size(); ++i) {
            const QString id = QString("candidate-%1").arg(i + 1);
            QVERIFY(says(elements, "a", headline(all[i])));
            QVERIFY(says(elements, "h1", headline(all[i]) + '.'));
            QVERIFY(std::ranges::any_of(elements, [&](const Element& e) { return e.attributes.value("id") == id; }));
            QVERIFY(std::ranges::any_of(elements,
                                        [&](const Element& e) { return e.attributes.value("href") == '#' + id; }));
        }
        QCOMPARE(countOf(elements, "title"), 1);
        QCOMPARE(countOfClass(elements, "facts"), 1);
        const QJsonObject json = jsonReport(CampaignReport{all, runs, "thesis", {}});
        QCOMPARE(json["comparisons"].toArray().size(), 2);
        QCOMPARE(json["comparisons"][1]["candidate"].toString(), QString("third"));
        QCOMPARE(json["exit_code"].toInt(), exitCodeOf(all));
        const QString text = textReport(all);
        QVERIFY2(text.endsWith(headline(all[0]) + ".\n" + headline(all[1]) + ".\n"), qPrintable(text));
    }

    void aCurveEndsBelowAllWhereRunsFailed() {
        const std::vector<RunFigures> runs = runsWithFailures();
        std::vector<double> ends_px; // of the baseline and the candidate, from the top
        for (const Element& element : elementsOf(htmlReport({compare(runs, "old", "new").value(), runs, "", {}})))
            if (element.name == "path")
                ends_px.push_back(element.attributes.value("d").toString().section(' ', -1).toDouble());
        QCOMPARE(ends_px.size(), std::size_t{2});
        QVERIFY(ends_px[1] > ends_px[0] + 20.0); // an eighth of the plot is 28 pixels
    }

    void aFewFailuresDoNotFlattenThePlot() {
        std::vector<RunFigures> runs = doneRuns(100, {});
        const auto plotted = [&] { return htmlReport({compare(runs, "old", "new").value(), runs, "", {}}); };
        QVERIFY(!plotted().contains(" up to "));
        for (RunFigures& figures : runs)
            if (figures.variant == "new" && figures.pair % 20 == 0)
                figures.metrics["duration_s"] = 9'000.0;
        QVERIFY(plotted().contains(">5 up to +89")); // thousands of seconds more
        QVERIFY(htmlReport({compare(runs, "new", "old").value(), runs, "", {}}).contains(">5 down to \u221289"));
        for (RunFigures& figures : runs)
            if (figures.variant == "new" && figures.pair % 5 == 0)
                figures.metrics["duration_s"] = 9'000.0;
        QVERIFY(!plotted().contains(" up to "));
    }

    void aCampaignWithoutPairsHasAPageAsWell() {
        const std::vector<RunFigures> runs{run("old", 1), run("new", 2)};
        const std::vector<Element> elements =
            elementsOf(htmlReport({compare(runs, "old", "new").value(), runs, "", {}}));
        QVERIFY(says(elements, "h1", "Whether new is worse than old is undecided."));
        QVERIFY(says(elements, "p", "2 runs have no partner of the same seed."));
    }

    void ticksAreRound_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<QString>("texts");
        QTest::newRow("hundreds") << 103.0 << 412.0 << "200 300 400";
        QTest::newRow("around zero") << -1.0 << 1.0 << u8"−1.0 −0.5 0.0 0.5 1.0";
        QTest::newRow("small") << 0.0 << 0.05 << "0.00 0.01 0.02 0.03 0.04 0.05";
        QTest::newRow("no range") << 3.0 << 3.0 << "3";
    }
    void ticksAreRound() {
        QFETCH(double, low);
        QFETCH(double, high);
        QStringList texts;
        const std::vector<double> values = ticks(low, high, 4);
        for (const double value : values)
            texts << tickText(value, values);
        QTEST(texts.join(' '), "texts");
    }
};

USAR_TEST(tst_ComparisonReports)

} // namespace tst_comparison_reports

#include "tst_comparison_reports.moc"
