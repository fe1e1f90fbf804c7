#include "widgets/plan/plan_editor.h"

#include <algorithm>

#include <QScopedValueRollback>
#include <QStyle>
#include <QTextBlock>
#include <QVBoxLayout>

#include "core/agent/posh/posh_binding.h"
#include "core/posh/edit/plan_templates.h"
#include "widgets/models/plan/plan_places.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

using posh::PlanEdit;
using posh::PlanPart;

namespace {

constexpr int draw_after_ms = 60;
constexpr int lamp_after_ms = 300;
constexpr std::size_t long_text = 200'000; ///< longer texts are drawn when the user pauses
constexpr int long_draw_after_ms = 400;

} // namespace

PlanEditor::PlanEditor(QWidget* parent) : QWidget(parent) {
    body_ = new QSplitter(this);
    column_ = new QSplitter(Qt::Vertical, this);
    palette_ = new PlanPalette(this);
    setAccessibleName(tr("Plan editor"));
    QWidget* const text_pane = makeTextPane();
    QWidget* const drawing_pane = makeDrawingPane();
    QWidget* const lists = makeLists();
    makeFileCommands();
    makeEditCommands();
    makePartCommands();
    makeListCommands();
    makeMenus();
    body_->addWidget(palette_);
    body_->addWidget(text_pane);
    body_->addWidget(drawing_pane);
    body_->setHandleWidth(gap::small);
    body_->setStretchFactor(1, 2);
    body_->setStretchFactor(2, 3);
    column_->addWidget(body_);
    column_->addWidget(lists);
    column_->setStretchFactor(0, 1);
    column_->setHandleWidth(gap::small);
    state_ = new QLabel(this);
    state_->setWordWrap(true);
    state_->hide();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(gap::small, gap::small, gap::small, gap::small);
    column->setSpacing(gap::tiny);
    // By default the minimum width of the wide rows would keep the editor from becoming narrow.
    column->setSizeConstraint(QLayout::SetNoConstraint);
    column->addWidget(makeHead());
    column->addWidget(makeOffer());
    column->addWidget(column_, 1);
    column->addWidget(state_);
    connectAll();
    setText(posh::planTemplates().front().text, tr("new.lap"));
}

PlanEditor::~PlanEditor() = default;

void PlanEditor::connectAll() {
    for (QTimer* const timer : {&check_timer_, &draw_timer_, &lamp_timer_})
        timer->setSingleShot(true);
    lamp_timer_.setInterval(lamp_after_ms);
    connect(&check_timer_, &QTimer::timeout, this, qOverload<>(&PlanEditor::check));
    connect(&draw_timer_, &QTimer::timeout, this, &PlanEditor::draw);
    connect(&lamp_timer_, &QTimer::timeout, this, [this] {
        const bool can = text_->planText().size() < long_text && !mends().empty();
        text_->setLamp(can && text_->findingAtCursor());
        mend_->setVisible(can);
    });
    connect(text_, &PlanCodeEdit::textEdited, this, &PlanEditor::edited);
    connect(text_, &PlanCodeEdit::mendsRequested, this, &PlanEditor::showMends);
    connect(text_, &PlanTextEdit::placeEntered, this, &PlanEditor::followCursor);
    connect(text_->document(), &QTextDocument::modificationChanged, this, &PlanEditor::showState);
    canvas_->setGestures([this] { return gestures(); });
    connect(canvas_, &PlanView::selectionChanged, this, &PlanEditor::followSelection);
    connect(canvas_, &PlanCanvas::rangeChanged, this, [this] {
        enableCommands();
        if (const auto count = canvas_->range().size(); count > 1)
            say(tr("%1 parts are taken along; they can be wrapped in one.").arg(count));
    });
    connect(canvas_, &PlanCanvas::menuRequested, this, &PlanEditor::showMenu);
    connect(canvas_, &PlanCanvas::wordsEntered, this, &PlanEditor::enterWords);
    connect(canvas_, &PlanView::activated, this, [this](int node) { jumpTo(canvas_->tree()[node].at); });
    connect(canvas_, &PlanCanvas::deedRequested, this, [this](const PlanDeed& deed) { perform(deed.edit()); });
    connect(canvas_, &PlanCanvas::dropRefused, this, [this] {
        say(gestures() ? tr("This means nothing there.") : tr("Mend the text first; then the drawing can be edited."),
            true);
    });
    connect(palette_, &PlanPalette::wordsChanged, this, [this] { text_->setWords(palette_->words()); });
    connect(palette_, &PlanPalette::pieceRequested, this, [this](const PlanPiece& piece) {
        const PlanGestures* const can = gestures();
        const auto deed = can ? can->add(piece, canvas_->selected()) : std::nullopt;
        deed ? perform(deed->edit()) : say(tr("Select a part in the drawing that this can be added to."), true);
    });
    connect(&file_, &PlanFile::changedOnDisk, this, [this](const std::string& text) {
        if (text == text_->planText())
            return text_->document()->setModified(false);
        text_->document()->setModified(true);
        offer(tr("%1 was changed by another program.").arg(name()), tr("Take its text"), [this, text] {
            text_->applyText(text);
            text_->document()->setModified(false);
            catchUp();
        });
    });
    text_->setWords(palette_->words());
    for (QWidget* const child : findChildren<QWidget*>())
        if (!qobject_cast<QLineEdit*>(child))
            child->installEventFilter(this);
}

void PlanEditor::setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives) {
    primitives_ = primitives;
    vocabulary_ = {};
    for (const agent::PrimitiveDescription& primitive : primitives)
        (primitive.kind == agent::PrimitiveKind::Sense ? vocabulary_.senses : vocabulary_.acts)
            .push_back(primitive.name);
    vocabulary_.senses.insert(vocabulary_.senses.end(), {"succeed", "fail"});
    vocabulary_.acts.emplace_back("doNothing");
    palette_->setPrimitives(primitives);
    is_checked_ = false;
    check();
}

void PlanEditor::setRunningPlan(const QString& name, const std::string& text) {
    running_name_ = name;
    running_text_ = text;
    enableCommands();
}

void PlanEditor::setApplicable(bool applicable, const QString& why_not) {
    applicable_ = applicable;
    why_not_applicable_ = why_not;
    showState();
}

void PlanEditor::setText(const std::string& text, const QString& name) {
    file_.startNew(name, text);
    offer_->hide();
    text_->resetText(text);
    catchUp();
    canvas_->select(-1);
    canvas_->showBeginning();
    showState();
    emit titleChanged();
}

void PlanEditor::setKeepingFolder(const QString& folder) {
    file_.setKeepingFolder(folder);
    offerKept();
}

void PlanEditor::offerKept() {
    if (const auto kept = file_.kept(); kept && *kept != text_->planText())
        offer(tr("%1 had changes that were not saved when the program ended.").arg(name()), tr("Restore them"),
              [this, text = *kept] {
                  text_->applyText(text);
                  catchUp();
              });
}

Result<void> PlanEditor::open(const QString& path) {
    const auto text = file_.open(path);
    if (!text)
        return tl::unexpected(text.error());
    offer_->hide();
    text_->resetText(*text);
    catchUp();
    canvas_->select(-1);
    canvas_->showBeginning();
    offerKept();
    showState();
    emit titleChanged();
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
    emit titleChanged();
    emit saved(path);
    return {};
}

void PlanEditor::saveNow() {
    if (path().isEmpty())
        return emit saveAsRequested();
    if (const auto written = save(path()); !written)
        emit saveFailed(written.error());
}

void PlanEditor::edited() {
    is_checked_ = false;
    say({});
    check_timer_.start(0);
    draw_timer_.start(text_->planText().size() > long_text ? long_draw_after_ms : draw_after_ms);
    if (text_->document()->isModified())
        file_.keep(text_->planText());
}

const posh::Findings& PlanEditor::findings() {
    if (!is_checked_)
        check();
    return findings_;
}

posh::Findings PlanEditor::check(std::string_view text, posh::Plan* plan) const {
    posh::PlanReading reading = posh::readPlan(text);
    if (binds() && isReadable(reading.findings)) {
        const bool is_sound = !posh::hasErrors(reading.findings);
        posh::Findings bound =
            is_sound ? agent::bindPlan(text, primitives_).findings : agent::checkBinding(reading.plan, primitives_);
        if (is_sound)
            reading.findings = std::move(bound);
        else
            reading.findings.insert(reading.findings.end(), bound.begin(), bound.end());
    }
    if (plan)
        *plan = std::move(reading.plan);
    return std::move(reading.findings);
}

/// Reads and checks the current text and shows the findings.
void PlanEditor::check() {
    check_timer_.stop();
    if (!is_checked_) {
        findings_ = check(text_->planText(), &checked_plan_);
        is_checked_ = true;
    }
    text_->setFindings(findings_, notesOf(checked_plan_));
    showFindings();
    showState();
}

/// Draws the plan, unless the text cannot be parsed: a missing parenthesis would remove half of the drawing.
void PlanEditor::draw() {
    draw_timer_.stop();
    if (!is_checked_)
        check();
    const bool readable = isReadable(findings_);
    const bool keeps = !readable && !canvas_->tree().empty() && !drawn_text_.empty();
    stale_->setVisible(!readable);
    if (!readable) {
        const auto first =
            std::ranges::find_if(findings_, [](const auto& finding) { return isUnreadable(finding.code); });
        stale_->setText(keeps ? tr("The drawing shows the plan before the error in line %1.").arg(first->at.line)
                              : tr("What can be read is drawn; there is an error in line %1.").arg(first->at.line));
    }
    if (!keeps) {
        gestures_.reset();
        drawn_text_ = readable ? text_->planText() : std::string();
        drawn_plan_ = checked_plan_;
        const QScopedValueRollback quiet(from_text_, true);
        if (canvas_->isVisible() && !canvas_->tree().empty())
            canvas_->holdStill();
        canvas_->setPlan(drawn_plan_);
        palette_->setPlan(drawn_plan_);
        if (readable)
            gestures_.emplace(drawn_text_, drawn_plan_, canvas_->tree());
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

const PlanGestures* PlanEditor::gestures() {
    return gestures_ && isDrawn() ? &*gestures_ : nullptr;
}

std::vector<posh::QuickFix> PlanEditor::mends() {
    if (findings().empty())
        return {};
    const posh::Finding* const finding = text_->findingAtCursor();
    if (!finding)
        return {};
    return posh::quickFixes(text_->planText(), *finding, vocabulary_,
                            [this](std::string_view text) { return check(text, nullptr); });
}

void PlanEditor::showMends() {
    check();
    const std::vector<posh::QuickFix> all = mends();
    if (all.empty())
        return say(text_->findingAtCursor()
                       ? tr("Nothing is known that would mend this; the sentence says what to write.")
                       : tr("There is no finding in this line. F8 goes to the next."));
    auto* const menu = new QMenu(text_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const posh::QuickFix& fix : all)
        connect(menu->addAction(QString::fromStdString(fix.title)), &QAction::triggered, this,
                [this, edits = fix.edits, revision = text_->document()->revision()] {
                    if (revision != text_->document()->revision())
                        return;
                    text_->applyEdits(edits);
                    catchUp();
                    text_->setFocus();
                });
    menu->setActiveAction(menu->actions().front());
    menu->popup(text_->viewport()->mapToGlobal(text_->cursorRect().bottomLeft()));
}

/// Shows the title and whether the plan can be put into the robot.
void PlanEditor::showState() {
    const QString title = name() + (isModified() ? tr(" – not saved") : QString());
    if (title != title_->text()) {
        title_->setText(title);
        title_->setToolTip(path().isEmpty() ? tr("It has no file yet") : path());
        emit titleChanged();
    }
    const bool has_errors = posh::hasErrors(findings_) || !posh::collectionOf(checked_plan_);
    QAction* const apply = action("apply");
    apply->setEnabled(applicable_ && !has_errors);
    apply_->setEnabled(apply->isEnabled());
    apply_->setToolTip(!applicable_ ? why_not_applicable_
                       : has_errors ? tr("The plan has errors; mend them first")
                                    : apply->toolTip());
    apply_->setVisible(applicable_ || !why_not_applicable_.isEmpty());
}

void PlanEditor::say(const QString& words, bool refused) {
    state_->setProperty("role", refused ? "danger" : "muted");
    state_->style()->unpolish(state_);
    state_->style()->polish(state_);
    state_->setText(words);
    state_->setVisible(!words.isEmpty());
}

void PlanEditor::followCursor(int line, int column) {
    text_->showPlace({}); // Removes the mark of the part that was selected in the drawing.
    showFindingAtCursor();
    if (!isDrawn())
        return;
    const QScopedValueRollback from_text(from_text_, true);
    if (const int node = nodeAtPlace(canvas_->tree(), line, column); node >= 0)
        canvas_->select(node);
    enableCommands();
}

void PlanEditor::followSelection() {
    const int node = canvas_->selected();
    if (!from_text_ && isDrawn())
        text_->showPlace(node < 0 ? posh::Spot() : canvas_->tree()[node].at);
    enableCommands();
}

void PlanEditor::jumpTo(const posh::Spot& at) {
    text_shown_->setChecked(true);
    text_->showPlace({});
    QTextCursor cursor(text_->document()->findBlockByNumber(static_cast<int>(at.line) - 1));
    if (cursor.isNull())
        return;
    cursor.setPosition(cursor.position() + rangeOf(at, cursor.block().text()).start);
    text_->setTextCursor(cursor);
    text_->centerCursor();
    text_->setFocus(Qt::OtherFocusReason);
}

std::optional<PlanPart> PlanEditor::selectedPart() {
    return partOfNode(drawn_plan_, canvas_->tree(), canvas_->selected());
}

std::optional<PlanPart> PlanEditor::selectedCall() {
    return callOfNode(drawn_plan_, canvas_->tree(), canvas_->selected());
}

/// Makes an edit as one undo step, draws the result and selects the edited part.
void PlanEditor::perform(const Result<PlanEdit>& edit) {
    if (!edit)
        return say(QString::fromStdString(edit.error().text()), true);
    const QScopedValueRollback from_drawing(from_drawing_, true);
    text_->applyText(edit->text);
    catchUp();
    if (const int node = nodeOfPart(drawn_plan_, canvas_->tree(), edit->part); node >= 0)
        canvas_->select(node);
    followSelection();
}

void PlanEditor::perform(const std::function<Result<PlanEdit>(const std::string&, const PlanPart&)>& edit) {
    if (!gestures())
        return say(tr("Mend the text first; then the drawing can be edited."), true);
    auto part = selectedPart();
    if (const auto call = selectedCall(); call && posh::isStep(drawn_plan_, *call))
        part = call; // If the part is a form called in a pattern, the step is meant.
    if (!part)
        return say(tr("Select a part in the drawing first."), true);
    perform(edit(drawn_text_, *part));
}

} // namespace usar::widgets
