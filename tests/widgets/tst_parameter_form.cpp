#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "core/base/geometry.h"
#include "tests/suite/suite.h"
#include "widgets/models/parameter_display.h"
#include "widgets/panels/parameter_form.h"
#include "widgets/panels/quantity_box.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"

namespace tst_parameter_form {

using namespace usar;
using namespace usar::widgets;
using agent::ParameterPreset;
using agent::ParameterSpec;
using agent::ParameterValue;
using Values = std::map<std::string, ParameterValue>;

namespace {

ParameterSpec real(const char* unit, double value, double minimum, double maximum) {
    return {"p", "P", "G", unit, value, minimum, maximum, "", {}};
}

const std::vector<ParameterSpec> specs = {
    {"scan_altitude_m", "Scan altitude", "Flight", "m", 6.0, 2.0, 40.0, "Height over the ground while scanning.", {}},
    {"tilt_rad", "Tilt limit", "Flight", "rad", 0.3, 0.0, 1.0, "How far it may lean.", {}},
    {"lanes", "Lanes", "Coverage", "", 9LL, 1.0, 99.0, "", {}},
    {"recharge", "Recharge", "Battery", "", true, 0.0, 0.0, "", {}},
    {"sweep", "Sweep", "Coverage", "", std::string("longer side"), 0.0, 0.0, "", {"longer side", "shorter side"}},
    {"note", "Note", "", "", std::string("none"), 0.0, 0.0, "", {}},
    {"floor_m", "Floor", "Flight", "m", -500.0, -500.0, 5000.0, "", {}, "by the robot"},
};

const std::vector<ParameterPreset> presets = {
    {"high", "High", "Far above the trees.", {{"scan_altitude_m", 12.0}, {"tilt_rad", radians(34.0)}}},
    {"slow", "Slow", "Exact.", {{"lanes", 20LL}}},
};

} // namespace

class tst_ParameterForm : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void decimalsShowTheDefault_data();
    void decimalsShowTheDefault();
    void stepsAreRound_data();
    void stepsAreRound();
    void toolTipSaysWhatUnitRangeDefault();
    void valuesThatDoNotFitBecomeTheDefault();
    void startsAtTheDefaults();
    void anglesAreShownInDegrees();
    void showingAnAngleDoesNotChangeIt();
    void boundInDegreesStaysInRangeInRadians();
    void typingTellsTheNewValue();
    void commaIsAPoint();
    void outOfRangeIsPulledIn();
    void wordsStandForTheLowestNumber();
    void wordsMayBeTypedForTheLowestNumber();
    void everyEditorEdits();
    void settingValuesIsSilentAndTakesWholeNumbersForReals();
    void strangeValuesAreIgnored();
    void resetGivesTheDefaultBack();
    void resetAllGivesAllBackAndTellsOnce();
    void searchLooksAtLabelIdGroupAndHelp_data();
    void searchLooksAtLabelIdGroupAndHelp();
    void modifiedOnlyShowsWhatDiffers();
    void wheelOverAnEditorWithoutFocusScrollsTheForm();
    void fitsInto280Pixels();
    void specsMayChangeInAnswerToAnEdit();
    void sameSpecsAgainKeepTheValues();
    void eachBehaviorKeepsItsValues();
    void aPresetSetsAllValues();
    void theListShowsWhichPresetTheValuesAre();
    void withoutPresetsThereIsNoList();
    void emptyFormSaysSo();

private:
    template <class T>
    T* editor(const char* id) {
        return form_->findChild<T*>(QString::fromLatin1(id));
    }
    ParameterRow* row(const char* id) { return qobject_cast<ParameterRow*>(editor<QWidget>(id)->parentWidget()); }
    QStringList visibleIds() const;

    std::unique_ptr<ParameterForm> form_;
    Values told_;
    int tells_ = 0;
};

void tst_ParameterForm::initTestCase() {
    applyTheme(Theme::Dark);
}

void tst_ParameterForm::init() {
    form_ = std::make_unique<ParameterForm>();
    form_->resize(320, 400);
    form_->setSpecs(specs);
    form_->show();
    QVERIFY(QTest::qWaitForWindowExposed(form_.get()));
    tells_ = 0;
    connect(form_.get(), &ParameterForm::changed, this, [this](const Values& values) {
        told_ = values;
        ++tells_;
    });
}

void tst_ParameterForm::cleanup() {
    form_.reset();
}

QStringList tst_ParameterForm::visibleIds() const {
    QStringList ids;
    for (const ParameterRow* row : form_->findChildren<ParameterRow*>())
        if (row->isVisible())
            ids << QString::fromStdString(row->spec().id);
    ids.sort();
    return ids;
}

void tst_ParameterForm::decimalsShowTheDefault_data() {
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("maximum");
    QTest::addColumn<int>("decimals");
    QTest::newRow("wide range") << "m" << 6.0 << 400.0 << 1;
    QTest::newRow("narrow range") << "m" << 0.5 << 1.0 << 3;
    QTest::newRow("default finer than the range") << "m" << 0.0625 << 400.0 << 4;
    QTest::newRow("thirty degrees") << "rad" << pi / 6 << pi << 1;
    QTest::newRow("0.3 rad is no round angle") << "rad" << 0.3 << pi << 2;
}

void tst_ParameterForm::decimalsShowTheDefault() {
    QFETCH(QString, unit);
    QFETCH(double, value);
    QFETCH(double, maximum);
    QTEST(decimalsFor(real(unit.toLatin1().constData(), value, 0.0, maximum)), "decimals");
}

void tst_ParameterForm::stepsAreRound_data() {
    QTest::addColumn<double>("maximum");
    QTest::addColumn<double>("step");
    QTest::newRow("1") << 1.0 << 0.02;
    QTest::newRow("40") << 40.0 << 0.5;
    QTest::newRow("50") << 50.0 << 1.0;
    QTest::newRow("1000") << 1000.0 << 20.0;
    QTest::newRow("no range") << 0.0 << 1.0;
}

void tst_ParameterForm::stepsAreRound() {
    QFETCH(double, maximum);
    QTEST(stepFor(real("m", 0.0, 0.0, maximum)), "step");
}

void tst_ParameterForm::toolTipSaysWhatUnitRangeDefault() {
    ParameterSpec spec = real("rad", pi / 6, 0.0, pi / 2);
    spec.label = "Tilt <limit>";
    spec.help = "How far it leans.";
    const QString tip = parameterToolTip(spec);
    for (const char* part : {"Tilt &lt;limit&gt;", "How far it leans.", "Unit: °", "Range: 0", "90", "Default: 30"})
        QVERIFY2(tip.contains(QString::fromUtf8(part)), part);
}

void tst_ParameterForm::valuesThatDoNotFitBecomeTheDefault() {
    const ParameterSpec spec = real("m", 6.0, 2.0, 40.0);
    QCOMPARE(fitted(spec, 7LL), ParameterValue(7.0));
    QCOMPARE(fitted(spec, 41.0), ParameterValue(6.0));
    QCOMPARE(fitted(spec, std::string("seven")), ParameterValue(6.0));
    QCOMPARE(fitted(specs[4], std::string("both")), ParameterValue(std::string("longer side")));
}

void tst_ParameterForm::startsAtTheDefaults() {
    QCOMPARE(form_->values().size(), specs.size());
    for (const ParameterSpec& spec : specs)
        QVERIFY2(form_->values().at(spec.id) == spec.default_value, spec.id.c_str());
    QVERIFY(form_->modified().empty());
    QCOMPARE(tells_, 0);
}

void tst_ParameterForm::anglesAreShownInDegrees() {
    form_->setValues({{"tilt_rad", pi / 4}});
    QCOMPARE(editor<QuantityBox>("tilt_rad")->text(), QString::fromUtf8("45\u00a0°"));
}

void tst_ParameterForm::showingAnAngleDoesNotChangeIt() {
    const double odd = 0.123456789012345;
    form_->setValues({{"tilt_rad", odd}});
    QCOMPARE(std::get<double>(form_->values().at("tilt_rad")), odd);
}

void tst_ParameterForm::boundInDegreesStaysInRangeInRadians() {
    auto* box = editor<QuantityBox>("tilt_rad");
    box->setValue(box->maximum());
    QCOMPARE(std::get<double>(form_->values().at("tilt_rad")), 1.0);
    QVERIFY(agent::ParameterSet::make(specs, form_->values()));
}

void tst_ParameterForm::typingTellsTheNewValue() {
    auto* box = editor<QuantityBox>("scan_altitude_m");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("12.5"));
    QCOMPARE(tells_, 0);
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(tells_, 1);
    QCOMPARE(told_.at("scan_altitude_m"), ParameterValue(12.5));
    QCOMPARE(told_.size(), specs.size());
    QCOMPARE(form_->modified(), (Values{{"scan_altitude_m", 12.5}}));
}

void tst_ParameterForm::commaIsAPoint() {
    auto* box = editor<QuantityBox>("scan_altitude_m");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("7,25"));
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(form_->values().at("scan_altitude_m"), ParameterValue(7.25));
}

void tst_ParameterForm::outOfRangeIsPulledIn() {
    auto* box = editor<QuantityBox>("lanes");
    box->setValue(1e9);
    QCOMPARE(form_->values().at("lanes"), ParameterValue(99LL));
}

void tst_ParameterForm::wordsStandForTheLowestNumber() {
    const auto* box = editor<QuantityBox>("floor_m");
    QCOMPARE(box->text(), QStringLiteral("by the robot"));
    auto* line = box->findChild<QLineEdit*>();
    const int words_px = line->fontMetrics().horizontalAdvance(box->text());
    const int margins_px = 4; // Qt's line edit keeps two free on either side.
    QVERIFY2(words_px + margins_px <= line->contentsRect().width(), "the words are cut off");
    for (const char* part : {"Range: -500", "Default: by the robot"})
        QVERIFY2(parameterToolTip(specs.back()).contains(QString::fromUtf8(part)), part);
    form_->setValues({{"floor_m", 2.5}});
    QCOMPARE(box->text(), QString::fromUtf8("2.5\u00a0m"));
    QVERIFY(!parameterToolTip(specs.front()).contains(QStringLiteral("by the robot")));
}

void tst_ParameterForm::wordsMayBeTypedForTheLowestNumber() {
    form_->setValues({{"floor_m", 2.5}});
    auto* box = editor<QuantityBox>("floor_m");
    box->findChild<QLineEdit*>()->setText(QStringLiteral("by the robot"));
    box->interpretText();
    QCOMPARE(form_->values().at("floor_m"), ParameterValue(-500.0));
    QVERIFY(form_->modified().empty());
}

void tst_ParameterForm::everyEditorEdits() {
    editor<QCheckBox>("recharge")->click();
    editor<QComboBox>("sweep")->setCurrentText(QStringLiteral("shorter side"));
    auto* note = editor<QLineEdit>("note");
    note->setFocus();
    note->selectAll();
    QTest::keyClicks(note, QStringLiteral("hill"));
    QTest::keyClick(note, Qt::Key_Return);
    editor<QuantityBox>("lanes")->stepUp();
    const Values expected = {
        {"recharge", false}, {"sweep", std::string("shorter side")}, {"note", std::string("hill")}, {"lanes", 10LL}};
    QCOMPARE(form_->modified(), expected);
    QCOMPARE(tells_, 4);
}

void tst_ParameterForm::settingValuesIsSilentAndTakesWholeNumbersForReals() {
    form_->setValues({{"scan_altitude_m", 8LL}, {"recharge", false}, {"note", std::string("x")}});
    QCOMPARE(form_->values().at("scan_altitude_m"), ParameterValue(8.0));
    QCOMPARE(editor<QuantityBox>("scan_altitude_m")->value(), 8.0);
    QVERIFY(!editor<QCheckBox>("recharge")->isChecked());
    QCOMPARE(tells_, 0);
}

void tst_ParameterForm::strangeValuesAreIgnored() {
    form_->setValues({{"no_such", 8.0}, {"recharge", std::string("yes")}, {"lanes", -3LL}});
    QVERIFY(form_->modified().empty());
    QVERIFY(!form_->values().contains("no_such"));
}

void tst_ParameterForm::resetGivesTheDefaultBack() {
    auto* reset = row("tilt_rad")->findChild<QToolButton*>(QStringLiteral("reset"));
    QVERIFY(!reset->isVisible());
    form_->setValues({{"tilt_rad", 0.5}});
    QVERIFY(reset->isVisible());
    reset->click();
    QCOMPARE(std::get<double>(form_->values().at("tilt_rad")), 0.3);
    QVERIFY(!reset->isVisible());
    QCOMPARE(tells_, 1);
}

void tst_ParameterForm::resetAllGivesAllBackAndTellsOnce() {
    form_->setValues({{"tilt_rad", 0.5}, {"lanes", 3LL}});
    form_->resetAll();
    form_->resetAll();
    QVERIFY(form_->modified().empty());
    QCOMPARE(tells_, 1);
}

void tst_ParameterForm::searchLooksAtLabelIdGroupAndHelp_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QStringList>("ids");
    QTest::newRow("label, any case") << "SCAN ALT" << QStringList{"scan_altitude_m"};
    QTest::newRow("id") << "tilt_rad" << QStringList{"tilt_rad"};
    QTest::newRow("group") << "coverage" << QStringList{"lanes", "sweep"};
    QTest::newRow("help") << "lean" << QStringList{"tilt_rad"};
    QTest::newRow("nothing") << "zzz" << QStringList{};
    QTest::newRow("blank shows all") << "  " << QStringList{"floor_m",         "lanes", "note",    "recharge",
                                                            "scan_altitude_m", "sweep", "tilt_rad"};
}

void tst_ParameterForm::searchLooksAtLabelIdGroupAndHelp() {
    QFETCH(QString, words);
    const auto lines = form_->findChildren<QLineEdit*>();
    (*std::ranges::find(lines, QStringLiteral("Search parameters"), &QLineEdit::placeholderText))->setText(words);
    QTEST(visibleIds(), "ids");
}

void tst_ParameterForm::modifiedOnlyShowsWhatDiffers() {
    form_->setValues({{"lanes", 3LL}});
    const auto buttons = form_->findChildren<QToolButton*>();
    auto* only = *std::ranges::find(buttons, QStringLiteral("Modified"), &QToolButton::text);
    only->click();
    QCOMPARE(visibleIds(), QStringList{"lanes"});
    row("lanes")->findChild<QToolButton*>(QStringLiteral("reset"))->click();
    QCOMPARE(visibleIds(), QStringList{"lanes"});
    only->click();
    QCOMPARE(visibleIds().size(), qsizetype(specs.size()));
}

void tst_ParameterForm::wheelOverAnEditorWithoutFocusScrollsTheForm() {
    auto* box = editor<QuantityBox>("scan_altitude_m");
    box->clearFocus();
    const auto wheel = [&] {
        QWheelEvent event(QPointF(5, 5), box->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(box, &event);
    };
    wheel();
    QCOMPARE(box->value(), 6.0);
    box->setFocus();
    wheel();
    QCOMPARE(box->value(), 6.5);
}

void tst_ParameterForm::fitsInto280Pixels() {
    form_->resize(280, 400);
    QVERIFY(form_->minimumSizeHint().width() <= 280);
    form_->setValues({{"lanes", 3LL}});
    for (const ParameterRow* each : form_->findChildren<ParameterRow*>()) {
        const int right = each->mapTo(form_.get(), QPoint(each->width(), 0)).x();
        QVERIFY2(right <= 280 && each->minimumSizeHint().width() <= each->width(), each->spec().id.c_str());
    }
}

void tst_ParameterForm::specsMayChangeInAnswerToAnEdit() {
    connect(form_.get(), &ParameterForm::changed, form_.get(), [this] { form_->setSpecs({specs[0]}); });
    editor<QuantityBox>("lanes")->stepUp();
    QCOMPARE(form_->values().size(), 1U);
    QVERIFY(form_->modified().empty());
}

void tst_ParameterForm::sameSpecsAgainKeepTheValues() {
    form_->setValues({{"lanes", 12LL}, {"tilt_rad", 0.4}});
    const Values before = form_->values();
    form_->setSpecs(specs);
    QCOMPARE(form_->values(), before);
}

void tst_ParameterForm::eachBehaviorKeepsItsValues() {
    const std::vector<ParameterSpec> other = {specs[0], specs[3]};
    form_->setValues({{"scan_altitude_m", 8.5}, {"lanes", 12LL}});
    const Values first = form_->values();
    form_->setSpecs(other);
    QCOMPARE(form_->values().at("scan_altitude_m"), specs[0].default_value);
    form_->setValues({{"recharge", false}});
    const Values second = form_->values();
    form_->setSpecs({});
    form_->setSpecs(specs);
    QCOMPARE(form_->values(), first);
    form_->setSpecs(other);
    QCOMPARE(form_->values(), second);
    QCOMPARE(tells_, 0);
}

void tst_ParameterForm::aPresetSetsAllValues() {
    form_->setValues({{"lanes", 12LL}, {"note", std::string("mine")}});
    form_->setPresets(presets);
    QTest::keyClick(editor<QComboBox>("preset"), Qt::Key_S);
    QCOMPARE(tells_, 1);
    QCOMPARE(told_, form_->values());
    QCOMPARE(form_->modified(), presets[1].values);
    QTest::keyClick(editor<QComboBox>("preset"), Qt::Key_Home);
    QCOMPARE(tells_, 2);
    QVERIFY(form_->modified().empty());
}

void tst_ParameterForm::theListShowsWhichPresetTheValuesAre() {
    auto* const list = editor<QComboBox>("preset");
    form_->setPresets(presets);
    QCOMPARE(list->currentText(), QString("Defaults"));
    form_->setValues(presets[0].values);
    QCOMPARE(list->currentText(), QString("High"));
    QVERIFY(list->toolTip().startsWith("Far above the trees."));
    QCOMPARE(list->accessibleDescription(), list->toolTip());
    editor<QuantityBox>("tilt_rad")->stepUp();
    editor<QuantityBox>("tilt_rad")->stepDown(); // The degrees lose the last digits of the angle.
    QCOMPARE(list->currentText(), QString("High"));
    editor<QuantityBox>("lanes")->stepUp();
    QCOMPARE(list->currentText(), QString("Own values"));
    const Values own = form_->values();
    tells_ = 0;
    QTest::keyClick(list, Qt::Key_O); // Own values are no preset, and cannot be chosen.
    QCOMPARE(form_->values(), own);
    QCOMPARE(tells_, 0);
    form_->resetAll();
    QCOMPARE(list->currentText(), QString("Defaults"));
}

void tst_ParameterForm::withoutPresetsThereIsNoList() {
    auto* const list = editor<QComboBox>("preset");
    QVERIFY(!list->isVisible());
    form_->setPresets(presets);
    QVERIFY(list->isVisible());
    form_->setPresets({});
    QVERIFY(!list->isVisible());
}

void tst_ParameterForm::emptyFormSaysSo() {
    QVERIFY(!form_->findChild<EmptyState*>()->isVisible());
    form_->setSpecs({});
    QVERIFY(form_->findChild<EmptyState*>()->isVisible());
    QVERIFY(form_->values().empty());
}

USAR_TEST(tst_ParameterForm)

} // namespace tst_parameter_form

#include "tst_parameter_form.moc"
