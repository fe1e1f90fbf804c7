// Every part of the window says what it is, and everything that takes a quantity says its unit and its range.
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDesktopServices>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTest>
#include <QTextDocument>
#include <QToolBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QWhatsThis>

#include "core/server/embedded/program_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/commands/shortcut_sheet.h"
#include "widgets/panels/parameter_form.h"

namespace tst_window_help {

using namespace usar;

namespace {

/// The tooltip as a person reads it.
QString plainTip(const QWidget* widget) {
    QTextDocument text;
    widget->toolTip().startsWith('<') ? text.setHtml(widget->toolTip()) : text.setPlainText(widget->toolTip());
    return text.toPlainText().replace(QChar(0x00a0), u' ');
}

bool explains(const QWidget* widget) {
    return !widget->toolTip().isEmpty() || !widget->whatsThis().isEmpty();
}

/// True for parts that Qt makes inside of its own widgets.
bool isQts(const QWidget* widget) {
    return widget->objectName().startsWith("qt_") || qobject_cast<const QScrollBar*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget->parentWidget()) ||
           qobject_cast<const QComboBox*>(widget->parentWidget()) ||
           qobject_cast<const QLineEdit*>(widget->parentWidget()) ||
           qobject_cast<const QTabBar*>(widget->parentWidget()) ||
           QByteArray(widget->metaObject()->className()).startsWith("QComboBox") ||
           QByteArray(widget->metaObject()->className()).startsWith("QTableCorner");
}

bool takesAQuantity(const QWidget* widget) {
    return qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QSlider*>(widget);
}

/// A control that must explain itself.
bool speaks(const QWidget* widget) {
    return takesAQuantity(widget) || qobject_cast<const QAbstractButton*>(widget) ||
           qobject_cast<const QComboBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
           dynamic_cast<const widgets::Instrument*>(widget);
}

/// A list or a canvas may be explained by what is around it, up to the dock of which it is the content.
bool isExplained(const QWidget* widget, const QWidget* whole) {
    for (; widget != whole; widget = widget->parentWidget())
        if (explains(widget))
            return true;
    return explains(whole);
}

/// The button of an empty state without an action says nothing because nobody sees it.
bool isUnused(const QWidget* widget) {
    const auto* const button = qobject_cast<const QPushButton*>(widget);
    return button && button->isHidden() && button->text().isEmpty();
}

QString nameOf(const QWidget* widget) {
    return QStringLiteral("%1 '%2' '%3'")
        .arg(widget->metaObject()->className(), widget->accessibleName(), widget->objectName());
}

/// What the tooltip of a quantity lacks, in words; empty if nothing.
QString missing(const QWidget* widget) {
    const QString tip = plainTip(widget);
    if (!tip.contains("Range: "))
        return "no range in '" + tip + "'";
    QString unit;
    if (const auto* box = qobject_cast<const QDoubleSpinBox*>(widget))
        unit = box->suffix();
    if (const auto* box = qobject_cast<const QSpinBox*>(widget))
        unit = box->suffix();
    unit = unit.replace(QChar(0x00a0), u' ').trimmed();
    return tip.contains(unit) ? QString() : "no " + unit + " in '" + tip + "'";
}

/// What is not explained below this widget, in words.
QStringList unexplained(const QWidget* whole) {
    QStringList found;
    for (const QWidget* part : whole->findChildren<QWidget*>()) {
        if (isQts(part) || isUnused(part))
            continue;
        const bool interactive = part->isVisible() && part->focusPolicy() != Qt::NoFocus;
        if ((speaks(part) && !explains(part)) || (interactive && !isExplained(part, whole)))
            found << nameOf(part);
        else if (takesAQuantity(part) && !missing(part).isEmpty())
            found << nameOf(part) + ": " + missing(part);
    }
    return found;
}

} // namespace

/// Takes the place of the browser.
class OpenedPages : public QObject {
    Q_OBJECT
public:
    QList<QUrl> urls;
public slots:
    void take(const QUrl& url) { urls << url; }
};

class tst_WindowHelp : public QObject {
    Q_OBJECT
private slots:
    void everyPartOfADockIsExplained();
    void whatIsThisFollowsTheTooltip();
    void aboutNamesEveryLoadedLibrary();
    void theManualOpensItsPages();
    void theSheetOfKeysIsThereOnceAndHasThemAll();
};

void tst_WindowHelp::everyPartOfADockIsExplained() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart")); // Now the docks are full.
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().findChildren<widgets::ParameterRow*>().isEmpty(), soon_ms);
    QStringList found;
    for (QDockWidget* const dock : page.window().views().docks) {
        dock->show();
        dock->raise();
        QTRY_VERIFY2(!dock->visibleRegion().isEmpty(), qPrintable(dock->objectName()));
        for (const QString& what : unexplained(dock))
            found << dock->objectName() + ": " + what;
    }
    for (const QToolBar* bar : page.window().findChildren<QToolBar*>())
        for (const QString& what : unexplained(bar))
            found << bar->objectName() + ": " + what;
    for (const QString& what : found)
        qWarning().noquote() << what;
    QCOMPARE(found.size(), 0);
}

void tst_WindowHelp::whatIsThisFollowsTheTooltip() {
    WindowPage page;
    QPushButton* const stop = page.window().views().stop_all;
    for (const QString& help : {QString("Stops two robots"), QString("Stops three robots")}) {
        stop->setToolTip(help);
        QTest::keyClick(page.window().windowHandle(), Qt::Key_F1, Qt::ShiftModifier);
        QVERIFY(QWhatsThis::inWhatsThisMode());
        QCOMPARE(stop->whatsThis(), help);
        QWhatsThis::leaveWhatsThisMode();
    }
    for (const QDockWidget* dock : page.window().views().docks)
        QVERIFY2(dock->whatsThis().startsWith(dock->windowTitle() + ": "), qPrintable(dock->objectName()));
}

void tst_WindowHelp::aboutNamesEveryLoadedLibrary() {
    WindowPage page;
    page.window().commands().action("help.about")->trigger();
    const auto dialogs = page.window().findChildren<QDialog*>();
    const auto about =
        std::ranges::find_if(dialogs, [](const QDialog* d) { return d->windowTitle().startsWith("About"); });
    QVERIFY(about != dialogs.end() && !(*about)->isModal());
    const auto* const table = (*about)->findChild<QTreeWidget*>();
    QStringList names;
    for (int row = 0; row < table->topLevelItemCount(); ++row) {
        const QTreeWidgetItem& item = *table->topLevelItem(row);
        names << item.text(0);
        QVERIFY2(QRegularExpression("^\\d+(\\.\\d+)+$").match(item.text(1)).hasMatch(),
                 qPrintable(item.text(0) + item.text(1)));
    }
    for (const char* const name :
         {"Qt", "Bullet Physics", "sdformat", "Eigen", "QCustomPlot", "libpng", "libjpeg-turbo", "zlib"})
        QVERIFY2(names.contains(name), name);
    QVERIFY(QTest::qWaitForWindowExposed(*about));
    (*about)->grab().save(QStringLiteral(USAR_BINARY_DIR "/screenshots/about.png"));
    QTest::keyClick(*about, Qt::Key_Escape);
    QTRY_VERIFY((*about)->isHidden());
}

void tst_WindowHelp::theManualOpensItsPages() {
    if (!QFileInfo::exists(server::manualPage()))
        QSKIP("This build has no Markdown reader (cmark-gfm).");
    WindowPage page;
    OpenedPages opened;
    QDesktopServices::setUrlHandler("file", &opened, "take");
    page.window().commands().action("help.manual")->trigger();
    QDesktopServices::unsetUrlHandler("file");
    QCOMPARE(opened.urls.size(), 1);
    QVERIFY2(QFileInfo::exists(opened.urls.front().toLocalFile()), qPrintable(opened.urls.front().toString()));
}

/// Defect D20 of the review: each F1 opened one more sheet, on which keys of the map and Escape twice were missing.
void tst_WindowHelp::theSheetOfKeysIsThereOnceAndHasThemAll() {
    WindowPage page;
    for (int i = 0; i < 3; ++i)
        page.window().commands().action("help.shortcuts")->trigger();
    const auto sheets = page.window().findChildren<widgets::ShortcutSheet*>();
    QCOMPARE(sheets.size(), 1);
    QVERIFY(sheets.front()->isVisible() && !sheets.front()->isModal());
    QStringList texts;
    for (const QLabel* label : sheets.front()->findChildren<QLabel*>())
        texts << label->text();
    for (const char* const keys : {"Ctrl+.  Esc Esc", "N  Shift+N", "1 – 9"})
        QVERIFY2(texts.contains(QString(keys)), keys);
    QCOMPARE(texts.filter("Select robot").size(), 1);
    sheets.front()->close();
}

USAR_TEST(tst_WindowHelp)

} // namespace tst_window_help

#include "tst_window_help.moc"
