#include <algorithm>

#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace tst_theme {

using namespace usar::widgets;

namespace {

using Maker = QWidget* (*)();

template <class Control>
QWidget* made() {
    return new Control;
}

} // namespace

class tst_Theme : public QObject {
    Q_OBJECT
private slots:
    void contrastFollowsTheStandard();
    void textReadsOnEveryGround_data();
    void textReadsOnEveryGround();
    void fillsCarryTheirText_data();
    void fillsCarryTheirText();
    void robotColorsDiffer();
    void robotNumbersWrap();
    void marksKeepTheThesissColors();
    void figuresAreEquallyWide();
    void applyingReachesWidgetsThatExist();
    void emptyControlsCanBeSeen_data();
    void emptyControlsCanBeSeen();
    void buttonsOfDialogsHaveWordsOnly();
    void everyIconDrawsSomething();
    void unknownIconIsNull();
    void iconFollowsTheme();
};

void tst_Theme::contrastFollowsTheStandard() {
    QCOMPARE(qRound(contrast(Qt::black, Qt::white) * 10), 210);
    QCOMPARE(contrast(Qt::red, Qt::red), 1.0);
    QVERIFY(qAbs(contrast(QColor(0x777777), Qt::white) - 4.48) < 0.01);
}

void tst_Theme::textReadsOnEveryGround_data() {
    QTest::addColumn<QColor>("ink");
    QTest::addColumn<QColor>("ground");
    for (const auto& [name, theme] : {std::pair("dark", Theme::Dark), std::pair("light", Theme::Light)}) {
        const Tokens& t = tokens(theme);
        const std::pair<const char*, QColor> inks[] = {{"text", t.text},  {"muted", t.text_muted}, {"accent", t.accent},
                                                       {"ok", t.ok},      {"caution", t.caution},  {"danger", t.danger},
                                                       {"stale", t.stale}};
        const std::pair<const char*, QColor> grounds[] = {
            {"background", t.background}, {"surface", t.surface}, {"raised", t.raised}};
        for (int family = 0; family <= static_cast<int>(LineFamily::Other); ++family)
            for (const auto& [ground_name, ground] : grounds)
                QTest::addRow("%s: lines of family %d on %s", name, family, ground_name)
                    << lineColor(static_cast<LineFamily>(family), theme) << ground;
        for (const auto& [ink_name, ink] : inks)
            for (const auto& [ground_name, ground] : grounds)
                QTest::addRow("%s: %s on %s", name, ink_name, ground_name) << ink << ground;
    }
}

void tst_Theme::textReadsOnEveryGround() {
    QFETCH(QColor, ink);
    QFETCH(QColor, ground);
    const double ratio = contrast(ink, ground);
    QVERIFY2(ratio >= 4.5, qPrintable(QString::number(ratio)));
}

void tst_Theme::fillsCarryTheirText_data() {
    QTest::addColumn<Theme>("theme");
    QTest::newRow("dark") << Theme::Dark;
    QTest::newRow("light") << Theme::Light;
}

void tst_Theme::fillsCarryTheirText() {
    QFETCH(Theme, theme);
    const Tokens& t = tokens(theme);
    QVERIFY(contrast(t.on_fill, t.stop) >= 4.5);
    QVERIFY(contrast(inkOn(t.accent), t.accent) >= 4.5);
    for (int number = 1; number <= 9; ++number)
        QVERIFY(contrast(inkOn(robotColor(number)), robotColor(number)) >= 4.5);
}

void tst_Theme::robotColorsDiffer() {
    for (int a = 1; a <= 9; ++a)
        for (int b = a + 1; b <= 9; ++b) {
            const QColor ca = robotColor(a);
            const QColor cb = robotColor(b);
            const int apart =
                std::abs(ca.red() - cb.red()) + std::abs(ca.green() - cb.green()) + std::abs(ca.blue() - cb.blue());
            QVERIFY2(apart > 60, qPrintable(QStringLiteral("%1 and %2").arg(a).arg(b)));
        }
}

void tst_Theme::robotNumbersWrap() {
    QCOMPARE(robotColor(10), robotColor(1));
    QCOMPARE(robotColor(0), robotColor(9));
    QCOMPARE(robotColor(-8), robotColor(1));
}

void tst_Theme::marksKeepTheThesissColors() {
    using usar::agent::MarkKind;
    const auto hue = [](MarkKind kind) { return markColor(kind).hsvHue(); };
    QVERIFY(qAbs(hue(MarkKind::Path) - 120) < 30);
    QVERIFY(qAbs(hue(MarkKind::Diversion) - 225) < 20);
    QVERIFY(qAbs(hue(MarkKind::LowRisk) - 35) < 12);
    QVERIFY(hue(MarkKind::HighRisk) < 10);
    QVERIFY(qAbs(hue(MarkKind::Recharge) - 52) < 8);
    QVERIFY(qAbs(hue(MarkKind::Landing) - 275) < 20);
    QSet<QString> names;
    for (const MarkKind kind : all_mark_kinds)
        names.insert(markName(kind));
    QCOMPARE(names.size(), qsizetype(all_mark_kinds.size()));
}

void tst_Theme::figuresAreEquallyWide() {
    for (const FontRole role : {FontRole::Small, FontRole::Body, FontRole::Big}) {
        const QFontMetricsF metrics(themeFont(role));
        for (const QChar digit : QStringLiteral("123456789"))
            QCOMPARE(metrics.horizontalAdvance(digit), metrics.horizontalAdvance(u'0'));
    }
}

void tst_Theme::applyingReachesWidgetsThatExist() {
    applyTheme(Theme::Dark);
    QLabel label(QStringLiteral("here"));
    label.show();
    applyTheme(Theme::Light);
    QCOMPARE(currentTheme(), Theme::Light);
    QCOMPARE(label.palette().color(QPalette::WindowText), tokens(Theme::Light).text);
    applyTheme(Theme::Dark);
    QCOMPARE(label.palette().color(QPalette::WindowText), tokens(Theme::Dark).text);
}

void tst_Theme::emptyControlsCanBeSeen_data() {
    QTest::addColumn<Theme>("theme");
    QTest::addColumn<Maker>("make");
    QTest::addColumn<double>("least");
    for (const auto& [name, theme] : {std::pair("dark", Theme::Dark), std::pair("light", Theme::Light)}) {
        QTest::addRow("%s: check box", name) << theme << Maker(made<QCheckBox>) << 3.0;
        QTest::addRow("%s: field", name) << theme << Maker(made<QLineEdit>) << 1.4;
        QTest::addRow("%s: spin box", name) << theme << Maker(made<QSpinBox>) << 1.4;
    }
}

void tst_Theme::emptyControlsCanBeSeen() {
    QFETCH(Theme, theme);
    QFETCH(Maker, make);
    QFETCH(double, least);
    applyTheme(theme);
    QWidget page;
    QWidget* control = make();
    control->setParent(&page);
    control->setFocusPolicy(Qt::NoFocus);
    control->setGeometry(8, 8, 100, 24);
    page.resize(116, 40);
    page.show();
    const QImage image = page.grab().toImage();
    double strongest = 1.0;
    for (int x = 6; x < 14; ++x) // across the left outline
        strongest = std::max(strongest, contrast(image.pixelColor(x, 20), tokens().background));
    QVERIFY2(strongest >= least, qPrintable(QString::number(strongest)));
}

void tst_Theme::buttonsOfDialogsHaveWordsOnly() {
    applyTheme(Theme::Light);
    const QDialogButtonBox box(QDialogButtonBox::Close | QDialogButtonBox::Cancel | QDialogButtonBox::Save);
    QCOMPARE(box.buttons().size(), 3);
    for (const QAbstractButton* button : box.buttons())
        QVERIFY2(button->icon().isNull(), qPrintable(button->text()));
}

void tst_Theme::everyIconDrawsSomething() {
    for (const QString& name : iconNames()) {
        const QImage image = icon(name).pixmap(24, 24).toImage();
        int inked = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                inked += image.pixelColor(x, y).alpha() > 128 ? 1 : 0;
        QVERIFY2(inked > 10, qPrintable(name));
    }
}

void tst_Theme::unknownIconIsNull() {
    QVERIFY(icon(QStringLiteral("no-such-thing")).isNull());
}

void tst_Theme::iconFollowsTheme() {
    const QIcon stop = icon(QStringLiteral("stop"));
    applyTheme(Theme::Light);
    const QColor light = stop.pixmap(24, 24).toImage().pixelColor(12, 12);
    applyTheme(Theme::Dark);
    const QColor dark = stop.pixmap(24, 24).toImage().pixelColor(12, 12);
    QCOMPARE(light, tokens(Theme::Light).text);
    QCOMPARE(dark, tokens(Theme::Dark).text);
}

USAR_TEST(tst_Theme)

} // namespace tst_theme

#include "tst_theme.moc"
