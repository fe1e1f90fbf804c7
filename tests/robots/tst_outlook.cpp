// What is told of a survey before it starts, against what campaigns measured.
#include <cmath>

#include <QTest>

#include "robots/airrobot/descriptions.h"
#include "robots/airrobot/outlook.h"
#include "tests/suite/suite.h"

namespace tst_outlook {

using namespace usar;
using namespace usar::airrobot;

namespace {

const Rectangle quick_scan{{-30, -20}, {30, 20}};
const Rectangle tall_test{{-100, -100}, {100, 100}};

agent::ParameterSet presetOf(const std::string& name) {
    const auto description = AirRobot().description();
    const auto& behavior = description.behaviors.front();
    for (const agent::ParameterPreset& preset : behavior.presets)
        if (preset.id == name)
            return *agent::ParameterSet::make(behavior.parameters, preset.values);
    return *agent::ParameterSet::make(behavior.parameters, {});
}

Settings settingsOf(const std::string& preset) {
    return Settings::parameters.settings(presetOf(preset)).asAsked();
}

Survey surveyOver(const Rectangle& area, const Settings& settings) {
    return *Survey::make({"R1", Pose{}, area}, settings);
}

} // namespace

class tst_Outlook : public QObject {
    Q_OBJECT

private slots:
    void plannedLanesShowAsMuchAsMeasured_data() {
        QTest::addColumn<std::string>("preset");
        QTest::addColumn<Rectangle>("area");
        QTest::addColumn<double>("clutter");
        QTest::addColumn<double>("measured_pct");
        QTest::newRow("fast, meadow") << std::string("fast") << quick_scan << clutter::meadow << 98.9;
        QTest::newRow("exact, meadow") << std::string("exact") << quick_scan << clutter::meadow << 99.7;
        QTest::newRow("as in the thesis, meadow")
            << std::string("as-in-the-thesis") << quick_scan << clutter::meadow << 99.7;
        QTest::newRow("fast, woods") << std::string("fast") << tall_test << clutter::woods << 92.8;
        QTest::newRow("exact, woods") << std::string("exact") << tall_test << clutter::woods << 98.6;
        QTest::newRow("as in the thesis, woods")
            << std::string("as-in-the-thesis") << tall_test << clutter::woods << 99.0;
    }

    /// The figures are those of the presets in measured.md, none of which added lanes.
    void plannedLanesShowAsMuchAsMeasured() {
        QFETCH(std::string, preset);
        QFETCH(Rectangle, area);
        QFETCH(double, clutter);
        QFETCH(double, measured_pct);
        const Settings settings = settingsOf(preset);
        const double shown_pct = 100.0 * (1.0 - hiddenShare(surveyOver(area, settings).plan(), settings, clutter));
        QVERIFY2(std::abs(shown_pct - measured_pct) <= 0.8, qPrintable(QString::number(shown_pct)));
    }

    void clearGroundHidesNothingAndMoreClutterHidesMore() {
        const Settings settings = settingsOf("fast");
        const Survey survey = surveyOver(tall_test, settings);
        QVERIFY(hiddenShare(survey.plan(), settings, 0.0) < 1e-9);
        double last = 0.0;
        for (const double clutter : {0.1, 0.3, 1.0, 3.0}) {
            const double hidden = hiddenShare(survey.plan(), settings, clutter);
            QVERIFY(hidden > last && hidden < 1.0);
            last = hidden;
        }
    }

    void whatIsOutOfReachIsHidden() {
        Settings settings = settingsOf("exact");
        settings.lane_spacing_m = 60.0; // The scanner sees 18 m to each side.
        const double hidden = hiddenShare(surveyOver({{0, 0}, {120, 60}}, settings).plan(), settings, 0.0);
        QVERIFY2(std::abs(hidden - 0.4) < 0.03, qPrintable(QString::number(hidden)));
    }

    void lanesAreAddedWhereTheyAreWorthTheirWay() {
        Settings settings = settingsOf("balanced");
        constexpr double area_m2 = 40000.0;
        QCOMPARE(addedLanes(0.0, area_m2, settings).length_m, 0.0);
        QVERIFY(addedLanes(0.003, area_m2, settings).length_m < 1.0); // a meadow
        const AddedLanes woods = addedLanes(0.038, area_m2, settings);
        QVERIFY2(woods.length_m > 508.0 && woods.length_m < 792.0, // as measured
                 qPrintable(QString::number(woods.length_m)));
        QVERIFY(woods.shown > 0.0 && woods.shown < 0.038);
        settings.least_gain_m = settingsOf("fast").least_gain_m; // none are wanted
        QVERIFY(addedLanes(0.1, area_m2, settings).length_m < 1e-3);
    }

    void holdsWhatCampaignsMeasured_data() {
        QTest::addColumn<std::string>("preset");
        QTest::addColumn<Rectangle>("area");
        QTest::addColumn<double>("took_s");
        QTest::addColumn<double>("shown_pct");
        QTest::addColumn<double>("charges");
        const auto row = [](const char* preset, const Rectangle& area, double took_s, double shown_pct,
                            double charges) {
            QTest::addRow("%s, %.0f m", preset, area.width_m())
                << std::string(preset) << area << took_s << shown_pct << charges;
        };
        row("as-in-the-thesis", quick_scan, 539.0, 99.7, 0.0);
        row("fast", quick_scan, 218.0, 98.9, 0.0);
        row("balanced", quick_scan, 244.0, 99.1, 0.0);
        row("exact", quick_scan, 326.0, 99.7, 0.0);
        row("as-in-the-thesis", tall_test, 7402.0, 99.0, 8.6);
        row("fast", tall_test, 1837.0, 93.0, 3.0);
        row("balanced", tall_test, 2656.0, 97.5, 5.0);
        row("exact", tall_test, 3832.0, 98.5, 7.1);
    }

    /// The means of the campaign survey_settings.json (measured.md).
    void holdsWhatCampaignsMeasured() {
        QFETCH(std::string, preset);
        QFETCH(Rectangle, area);
        QFETCH(double, took_s);
        QFETCH(double, shown_pct);
        QFETCH(double, charges);
        const auto preview = AirRobot().preview({}, {{"R1", Pose{}, area}, presetOf(preset)});
        QVERIFY(preview && preview->outlook);
        const agent::TaskOutlook& told = *preview->outlook;
        const std::string text = outlookWords(told);
        QVERIFY2(told.duration.least.count() <= took_s && took_s <= told.duration.most.count(), text.c_str());
        QVERIFY2(told.duration.most.count() < 2.3 * told.duration.least.count(), text.c_str());
        QVERIFY2(told.least_coverage_pct - 0.8 <= shown_pct && shown_pct <= told.most_coverage_pct, text.c_str());
        QVERIFY2(told.least_sorties <= charges + 1.5 && charges + 0.5 <= told.most_sorties, text.c_str());
        QVERIFY(told.duration.least <= preview->duration && preview->duration <= told.duration.most);
        qInfo("%s", text.c_str());
    }
};

USAR_TEST(tst_Outlook)

} // namespace tst_outlook

#include "tst_outlook.moc"
