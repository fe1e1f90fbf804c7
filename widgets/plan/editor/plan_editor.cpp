#include "widgets/plan/editor/plan_editor.h"

#include <QResizeEvent>
#include <QScopedValueRollback>
#include <QTextBlock>

#include "core/posh/edit/plan_templates.h"
#include "widgets/models/plan/plan_places.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/plan/plan_picture.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int narrow_editor_px = 820;
constexpr int draw_after_ms = 60;
constexpr std::size_t long_text = 200'000; ///< longer texts are drawn when the user pauses
constexpr int long_draw_after_ms = 400;

} // namespace

PlanEditor::PlanEditor(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Plan editor"));
    addWidgets();
    connectAll();
    for (QWidget* const child : findChildren<QWidget*>())
        if (!qobject_cast<QLineEdit*>(child))
            child->installEventFilter(this);
    setText(posh::planTemplates().front().text, tr("new.lap"));
}

void PlanEditor::addWidgets() {
    body_ = new QSplitter(this);
    column_ = new QSplitter(Qt::Vertical, this);
    palette_ = new PlanPalette(this);
    text_pane_ = new PlanTextPane(this);
    text_ = &text_pane_->edit();
    drawing_ = new PlanDrawingPane(*text_, this);
    canvas_ = &drawing_->canvas();
    parts_ = &drawing_->parts();
    lists_ = new PlanLists(this);
    addFileCommands();
    addEditCommands();
    part_commands_ = new PlanPartCommands(actions_, *parts_, *canvas_, this);
    body_->addWidget(palette_);
    body_->addWidget(text_pane_);
    body_->addWidget(drawing_);
    body_->setHandleWidth(gap::small);
    body_->setStretchFactor(1, 2);
    body_->setStretchFactor(2, 3);
    column_->addWidget(body_);
    column_->addWidget(lists_);
    column_->setStretchFactor(0, 1);
    column_->setHandleWidth(gap::small);
    state_ = makeLabel(this);
    state_->hide();
    head_ = new PlanEditorHead(actions_, {palette_, text_pane_, drawing_, lists_}, menus_, this);
    offer_ = new PlanOfferBar(this);
    auto* column = laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::tiny,
                           {head_, offer_, column_, state_});
    // By default the minimum width of the wide rows would keep the editor from becoming narrow.
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->setStretchFactor(column_, 1);
    onThemeChange(this, [this] { showFindings(); });
}

/// A narrow editor stacks what a wide one shows side by side, and starts without the palette.
void PlanEditor::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const int narrow = width() < narrow_editor_px ? 1 : 0;
    if (narrow == narrow_)
        return;
    const bool first = narrow_ < 0;
    narrow_ = narrow;
    head_->setNarrow(narrow == 1);
    body_->setOrientation(narrow ? Qt::Vertical : Qt::Horizontal);
    head_->setPaletteShown(narrow == 0);
    body_->setSizes(narrow ? QList<int>{160, 300, 300} : QList<int>{200, 460, 620});
    if (first)
        column_->setSizes({600, 120});
}

void PlanEditor::connectAll() {
    check_timer_.setSingleShot(true);
    draw_timer_.setSingleShot(true);
    connect(&check_timer_, &QTimer::timeout, this, &PlanEditor::check);
    connect(&draw_timer_, &QTimer::timeout, this, &PlanEditor::draw);
    connect(text_pane_, &PlanTextPane::pausedAtFinding, this,
            [this] { text_pane_->setFixable(text().size() < long_text && !fixes().empty()); });
    connect(text_pane_, &PlanTextPane::fixesRequested, this, &PlanEditor::showFixes);
    connect(text_pane_, &PlanTextPane::fixed, this, &PlanEditor::catchUp);
    connect(text_, &PlanCodeEdit::textEdited, this, &PlanEditor::edited);
    connect(text_, &PlanTextEdit::placeEntered, this, &PlanEditor::followCursor);
    connect(text_, &QWidget::customContextMenuRequested, this, &PlanEditor::showTextMenu);
    connect(text_->document(), &QTextDocument::modificationChanged, this, &PlanEditor::showState);
    connect(lists_, &PlanLists::placeChosen, this, &PlanEditor::jumpTo);
    connect(palette_, &PlanPalette::wordsChanged, this, [this] { text_->setWords(palette_->words()); });
    connect(palette_, &PlanPalette::pieceRequested, parts_, &PlanPartEditor::addPiece);
    connect(&file_, &PlanFile::changedOnDisk, this, &PlanEditor::takeChangeOnDisk);
    text_->setWords(palette_->words());
    connect(canvas_, &PlanView::selectionChanged, this, &PlanEditor::followSelection);
    connect(canvas_, &PlanCanvas::rangeChanged, this, [this] {
        enableCommands();
        if (const auto count = canvas_->range().size(); count > 1)
            say(tr("%1 parts are selected; they can be wrapped in one.").arg(count));
    });
    connect(canvas_, &PlanCanvas::menuRequested, this, [this](PlanNodeId, const QPoint& global) {
        enableCommands();
        part_commands_->showMenu(global);
    });
    connect(canvas_, &PlanView::activated, this, [this](PlanNodeId node) { jumpTo(canvas_->tree()[node].at); });
    connect(parts_, &PlanPartEditor::editRequested, this, &PlanEditor::apply);
    connect(parts_, &PlanPartEditor::said, this, &PlanEditor::say);
    connect(parts_, &PlanPartEditor::drawingWanted, head_, &PlanEditorHead::showDrawing);
    connect(part_commands_, &PlanPartCommands::usagesRequested, this, [this] {
        const auto part = parts_->selectedCallOrPart();
        if (!part)
            return lists_->clearUsages();
        lists_->showUsages(parts_->plan(), *part);
        head_->showLists();
    });
    connect(part_commands_, &PlanPartCommands::textRequested, this, [this] {
        if (const PlanNodeId node = canvas_->selected(); node.valid())
            jumpTo(canvas_->tree()[node].at);
    });
}

void PlanEditor::setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives) {
    checker_.setPrimitives(primitives);
    parts_->setPrimitives(primitives);
    palette_->setPrimitives(primitives);
    check();
}

void PlanEditor::setRunningPlan(const QString& name, const std::string& text) {
    running_name_ = name;
    running_text_ = text;
    enableCommands();
}

void PlanEditor::setText(const std::string& text, const QString& name) {
    file_.startNew(name, text);
    startWith(text);
}

void PlanEditor::startWith(const std::string& text) {
    offer_->hide();
    text_->resetText(text);
    catchUp();
    canvas_->select({});
    canvas_->showBeginning();
    showState();
}

void PlanEditor::setKeepingFolder(const QString& folder) {
    file_.setKeepingFolder(folder);
    offerKept();
}

void PlanEditor::offerKept() {
    if (const auto kept = file_.kept(); kept && *kept != text_->planText())
        offer_->offer(tr("%1 had unsaved changes when the program ended.").arg(name()), tr("Restore them"),
                      [this, text = *kept] {
                          text_->applyText(text);
                          catchUp();
                      });
}

void PlanEditor::takeChangeOnDisk(const std::string& text) {
    if (text == text_->planText())
        return text_->document()->setModified(false);
    text_->document()->setModified(true);
    offer_->offer(tr("%1 was changed by another program.").arg(name()), tr("Use its text"), [this, text] {
        text_->applyText(text);
        text_->document()->setModified(false);
        catchUp();
    });
}

Result<void> PlanEditor::open(const QString& path) {
    const auto text = file_.open(path);
    if (!text)
        return tl::unexpected(text.error());
    startWith(*text);
    offerKept();
    return {};
}

Result<void> PlanEditor::save(const QString& path) {
    const auto written = file_.save(path, text_->planText());
    if (!written) {
        say(QString::fromStdString(written.error().text()), true);
        return written;
    }
    text_->document()->setModified(false);
    say(tr("Saved as %1.").arg(path));
    showState();
    emit saved(path);
    return {};
}

Result<QStringList> PlanEditor::exportTo(const QString& path, posh::Dialect dialect) {
    catchUp();
    if (!isReadable(checker_.findings()))
        return failure("the text cannot be read", name().toStdString(), "fix its errors first");
    const posh::PlanExport made = posh::exportPlan(posh::readPlan(text_->planText()).plan, dialect);
    if (const auto written = PlanFile::write(path, QByteArray::fromStdString(made.text)); !written)
        return tl::unexpected(written.error());
    lists_->showLosses(made.losses);
    QStringList losses;
    for (const posh::Loss& loss : made.losses)
        losses << QString::fromStdString(loss.message);
    say(losses.isEmpty() ? tr("Exported to %1; nothing was lost.").arg(path)
                         : tr("Exported to %1; that dialect cannot express %2 things.").arg(path).arg(losses.size()));
    return losses;
}

Result<void> PlanEditor::savePicture(const QString& path) {
    catchUp();
    return savePlanPicture(*canvas_, path);
}

void PlanEditor::edited() {
    checker_.invalidate();
    say({});
    check_timer_.start(0);
    draw_timer_.start(text_->planText().size() > long_text ? long_draw_after_ms : draw_after_ms);
    if (text_->document()->isModified())
        file_.keep(text_->planText());
}

const posh::Findings& PlanEditor::findings() {
    if (!checker_.isCurrent())
        check();
    return checker_.findings();
}

/// Reads and checks the current text and shows the findings.
void PlanEditor::check() {
    check_timer_.stop();
    checker_.check(text_->planText());
    text_->setFindings(checker_.findings(), notesOf(checker_.plan()));
    showFindings();
    showState();
}

void PlanEditor::showFindings() {
    lists_->showFindings(checker_.findings(), text_->notes());
    text_pane_->showFinding(checker_.binds());
}

void PlanEditor::draw() {
    draw_timer_.stop();
    findings(); // The text may have changed since the last check.
    {
        const QScopedValueRollback quiet(from_text_, true);
        if (drawing_->draw(checker_))
            palette_->setPlan(parts_->plan());
    }
    if (!from_drawing_ && text_->hasFocus())
        followCursor(text_->textCursor().blockNumber() + 1,
                     columnOf(text_->textCursor().block().text(), text_->textCursor().positionInBlock()));
    enableCommands();
}

void PlanEditor::catchUp() {
    check();
    draw();
}

std::vector<posh::QuickFix> PlanEditor::fixes() {
    if (findings().empty())
        return {};
    const posh::Finding* const finding = text_->findingAtCursor();
    return finding ? checker_.fixes(text_->planText(), *finding) : std::vector<posh::QuickFix>();
}

void PlanEditor::showFixes() {
    check();
    const std::vector<posh::QuickFix> all = fixes();
    if (all.empty())
        return say(text_->findingAtCursor() ? tr("No fix is known for this; the message says what to write.")
                                            : tr("There is no finding on this line. F8 goes to the next one."));
    text_pane_->showFixes(all);
}

/// Shows the title and whether the plan can be put into the robot.
void PlanEditor::showState() {
    if (head_->setTitle(name() + (isModified() ? tr(" – not saved") : QString()),
                        path().isEmpty() ? tr("Not saved to a file yet") : path())) {
        setWindowTitle(tr("%1[*] – Plan editor").arg(name()));
        setWindowModified(isModified());
    }
    head_->setRunnable(checker_.isRunnable());
}

void PlanEditor::say(const QString& words, bool refused) {
    setRole(state_, refused ? "danger" : "muted");
    state_->setText(words);
    state_->setVisible(!words.isEmpty());
}

void PlanEditor::followCursor(int line, int column) {
    text_->showPlace({}); // Removes the mark of the part that was selected in the drawing.
    text_pane_->showFinding(checker_.binds());
    if (!parts_->isDrawn())
        return;
    const QScopedValueRollback from_text(from_text_, true);
    if (const PlanNodeId node = nodeAtPlace(canvas_->tree(), line, column); node.valid())
        canvas_->select(node);
    enableCommands();
}

void PlanEditor::followSelection() {
    const PlanNodeId node = canvas_->selected();
    if (!from_text_ && parts_->isDrawn())
        text_->showPlace(node.valid() ? canvas_->tree()[node].at : posh::Spot());
    enableCommands();
}

void PlanEditor::jumpTo(const posh::Spot& at) {
    head_->showText();
    text_->showPlace({});
    QTextCursor cursor(text_->document()->findBlockByNumber(static_cast<int>(at.line) - 1));
    if (cursor.isNull())
        return;
    cursor.setPosition(cursor.position() + rangeOf(at, cursor.block().text()).start);
    text_->setTextCursor(cursor);
    text_->centerCursor();
    text_->setFocus(Qt::OtherFocusReason);
}

/// Makes an edit as one undo step, draws the result and selects the edited part.
void PlanEditor::apply(const posh::PlanEdit& edit) {
    const QScopedValueRollback from_drawing(from_drawing_, true);
    text_->applyText(edit.text);
    catchUp();
    if (const PlanNodeId node = nodeOfPart(parts_->plan(), canvas_->tree(), edit.part); node.valid())
        canvas_->select(node);
    followSelection();
}

void PlanEditor::compareWith(const std::string& other, const QString& name) {
    catchUp();
    const posh::PlanReading before = posh::readPlan(other);
    const std::vector<posh::PlanChange> changes = posh::planDifference(before.plan, checker_.plan());
    lists_->showDifferences(changes, !isReadable(before.findings) || !isReadable(checker_.findings()));
    head_->showLists();
    say(tr("Compared with %1: %2.").arg(name, QString::fromStdString(posh::summaryOf(changes))));
}

} // namespace usar::widgets
