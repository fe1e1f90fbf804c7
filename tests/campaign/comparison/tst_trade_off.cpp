#include <algorithm>
#include <cmath>

#include <QTest>
#include <QXmlStreamReader>

#include "core/campaign/comparison/trade_off.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_trade_off {

using namespace usar::campaign;
using usar::test::run;

namespace {

/// A run with these figures; not a number stands for none.
RunFigures flown(const std::string& variant, std::size_t pair, double duration_s, double rmse_m, double coverage_pct) {
    RunFigures figures = run(variant, pair);
    figures.metrics["duration_s"] = duration_s;
    if (std::isfinite(rmse_m))
        figures.metrics["rmse_m"] = rmse_m;
    figures.metrics["coverage_pct"] = coverage_pct;
    return figures;
}

/// Nine runs of each variant around its middle.
std::vector<RunFigures> runsOf(const std::vector<std::string>& variants) {
    std::vector<RunFigures> runs;
    for (std::size_t i = 0; i < variants.size(); ++i)
        for (int k = -4; k <= 4; ++k) {
            const auto place = static_cast<double>(i + 1);
            runs.push_back(flown(variants[i], static_cast<std::size_t>(k + 4), 100.0 * place + k,
                                 1.0 / place + 0.01 * k, 89.0 + place));
        }
    return runs;
}

/// All texts of the picture, or why it is not well-formed.
QStringList textsIn(const QByteArray& picture) {
    QStringList texts;
    QXmlStreamReader xml(picture);
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QStringLiteral("text"))
            texts << xml.readElementText();
    return xml.hasError() ? QStringList{xml.errorString()} : texts;
}

} // namespace

class tst_TradeOff : public QObject {
    Q_OBJECT
private slots:
    void eachVariantHasItsMedianAndQuartiles() {
        const std::vector<TradeOff> all = tradeOffsOf(runsOf({"slow", "fast", "exact"}));
        QCOMPARE(all.size(), std::size_t{2});
        QCOMPARE(all[0].y.key, std::string("rmse_m"));
        QCOMPARE(all[1].y.key, std::string("coverage_pct"));
        QCOMPARE(all[0].points.size(), std::size_t{3});
        const TradePoint& fast = all[0].points[1];
        QCOMPARE(fast.variant, std::string("fast"));
        QCOMPARE(fast.x.median, 200.0);
        QCOMPARE(fast.x.half.low, 198.0);
        QCOMPARE(fast.x.half.high, 202.0);
        QCOMPARE(fast.y.median, 0.5);
        QCOMPARE(fast.done, std::size_t{9});
    }

    void runsThatWereNotDoneAreCountedAndNotDrawn() {
        std::vector<RunFigures> runs = runsOf({"slow", "fast"});
        runs[17].outcome = Outcome::Failed; // the last one of fast, which took longest
        runs[16].outcome = Outcome::Killed; // It says nothing about the variant.
        const TradePoint fast = tradeOffsOf(runs)[0].points[1];
        QCOMPARE(fast.runs, std::size_t{8});
        QCOMPARE(fast.done, std::size_t{7});
        QCOMPARE(fast.x.median, 199.0);
        const QStringList texts = textsIn(tradeOffPicture(tradeOffsOf(runs), "Trade"));
        QVERIFY2(texts.contains("fast, 7 of 8 done"), qPrintable(texts.join('|')));
    }

    void whatHasNoFigureIsLeftOut() {
        std::vector<RunFigures> runs = runsOf({"slow", "fast"});
        for (RunFigures& figures : runs)
            if (figures.variant == "fast")
                figures.metrics.erase("rmse_m");
        const std::vector<TradeOff> all = tradeOffsOf(runs);
        QCOMPARE(all.size(), std::size_t{1}); // With one variant there is nothing to compare.
        QCOMPARE(all[0].y.key, std::string("coverage_pct"));
        QVERIFY(tradeOffPicture({}, "nothing").isEmpty());
    }

    void aSingleVariantHasOnePoint() {
        const std::vector<TradeOff> all = tradeOffsOf(runsOf({"alone"}));
        QCOMPARE(all.size(), std::size_t{2});
        QCOMPARE(all[0].points.size(), std::size_t{1});
        QCOMPARE(all[0].points[0].x.median, 100.0);
        QCOMPARE(textsIn(tradeOffPicture(all, "Trade")).count("alone"), 2);
        std::vector<RunFigures> runs = runsOf({"alone"});
        for (RunFigures& figures : runs)
            figures.outcome = Outcome::Failed;
        QVERIFY(tradeOffsOf(runs).empty());
    }

    void eachMissionHasItsOwn() {
        std::vector<RunFigures> runs = runsOf({"slow", "fast"});
        for (RunFigures other : runsOf({"slow", "fast"})) {
            other.mission = "attic";
            runs.push_back(other);
        }
        const std::vector<TradeOff> all = tradeOffsOf(runs);
        QCOMPARE(all.size(), std::size_t{4});
        QCOMPARE(all[3].mission, std::string("attic"));
        const QStringList texts = textsIn(tradeOffPicture(all, "Trade"));
        QCOMPARE(texts.count("slow"), 4);
        QVERIFY2(texts.contains("attic: Coverage, %"), qPrintable(texts.join('|')));
    }

    /// Variants that are equal would have their names on top of each other.
    void namesDoNotCoverEachOther() {
        std::vector<RunFigures> runs;
        const std::vector<std::string> variants{"one", "two", "three", "four"};
        for (const std::string& variant : variants)
            for (std::size_t pair = 0; pair < 5; ++pair)
                runs.push_back(flown(variant, pair, 100.0 + static_cast<double>(pair), 1.0, 99.0));
        QXmlStreamReader xml(tradeOffPicture(tradeOffsOf(runs), "Equal"));
        std::vector<double> heights;
        while (!xml.atEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QStringLiteral("text")) {
                const double y = xml.attributes().value("y").toDouble();
                const double x = xml.attributes().value("x").toDouble();
                if (std::ranges::count(variants, xml.readElementText().toStdString()) > 0 && x < 440.0)
                    heights.push_back(y);
            }
        QCOMPARE(heights.size(), variants.size());
        std::ranges::sort(heights);
        for (std::size_t i = 1; i < heights.size(); ++i)
            QVERIFY(heights[i] - heights[i - 1] > 13.0);
    }
};

USAR_TEST(tst_TradeOff)

} // namespace tst_trade_off

#include "tst_trade_off.moc"
