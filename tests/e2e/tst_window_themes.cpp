// A switch of the theme reaches every label and button of the window.
#include <QAbstractButton>
#include <QLabel>
#include <QTest>

#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/style/theme.h"

namespace tst_window_themes {

using namespace usar;

namespace {

bool hasText(const QWidget* widget) {
    const auto* const label = qobject_cast<const QLabel*>(widget);
    const auto* const button = qobject_cast<const QAbstractButton*>(widget);
    return (label && !label->text().isEmpty()) || (button && !button->text().isEmpty());
}

double contrastOf(const QWidget* widget) {
    const QPalette palette = widget->palette();
    const QPalette::ColorGroup group = widget->isEnabled() ? QPalette::Active : QPalette::Disabled;
    return widgets::contrast(palette.color(group, widget->foregroundRole()),
                             palette.color(group, widget->backgroundRole()));
}

/// What cannot be read, in words; empty if all labels and buttons that are seen have the contrast of WCAG's AA.
QStringList unreadable(const QWidget& window) {
    QStringList found;
    for (const QWidget* widget : window.findChildren<QWidget*>())
        if (widget->isVisible() && hasText(widget) && contrastOf(widget) < 4.5)
            found << QStringLiteral("%1 '%2' '%3' %4:1")
                         .arg(widget->metaObject()->className(), widget->accessibleName(),
                              widget->property("text").toString())
                         .arg(contrastOf(widget), 0, 'f', 2);
    return found;
}

} // namespace

class tst_WindowThemes : public QObject {
    Q_OBJECT
private slots:
    void everyWordIsReadableAfterASwitch();
};

void tst_WindowThemes::everyWordIsReadableAfterASwitch() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    for (const Severity severity : {Severity::Error, Severity::Warning})
        page.window().views().notifications->push(QString::number(int(severity)), severity, "Something is wrong.", true,
                                                  {}, QDateTime());
    QVERIFY(page.window().views().toasts->count() >= 2);
    for (int i = 0; i < 4; ++i) {
        page.window().commands().action("view.dark")->trigger();
        QCOMPARE(unreadable(page.window()), QStringList());
        for (QDockWidget* dock : page.window().views().docks) {
            dock->show();
            dock->raise();
            QTRY_VERIFY2(!dock->visibleRegion().isEmpty(), qPrintable(dock->objectName()));
            QCOMPARE(unreadable(*dock), QStringList());
        }
    }
    QCOMPARE(widgets::currentTheme(), widgets::Theme::Dark);
}

USAR_TEST(tst_WindowThemes)

} // namespace tst_window_themes

#include "tst_window_themes.moc"
