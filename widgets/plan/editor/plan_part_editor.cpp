#include "widgets/plan/editor/plan_part_editor.h"

#include <algorithm>
#include <utility>

#include "core/posh/edit/plan_phrase.h"
#include "widgets/plan/editor/plan_values_dialog.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

using posh::PlanEdit;
using posh::PlanPart;

PlanPartEditor::PlanPartEditor(PlanCanvas& canvas, const PlanCodeEdit& text, QWidget* owner)
    : QObject(owner)
    , canvas_(canvas)
    , text_(text)
    , owner_(owner) {
    canvas_.setGestures([this] { return gestures(); });
    connect(&canvas_, &PlanCanvas::wordsEntered, this, &PlanPartEditor::enterWords);
    connect(&canvas_, &PlanCanvas::deedRequested, this, [this](const PlanDeed& deed) { perform(deed.edit()); });
    connect(&canvas_, &PlanCanvas::dropRefused, this, [this] {
        emit said(gestures() ? tr("It cannot be dropped there.")
                             : tr("Fix the text first; then you can edit the drawing."),
                  true);
    });
}

void PlanPartEditor::draw(const posh::Plan& plan, bool is_readable) {
    gestures_.reset();
    drawn_text_ = is_readable ? text_.planText() : std::string();
    plan_ = plan;
    if (canvas_.isVisible() && !canvas_.tree().empty())
        canvas_.holdStill();
    canvas_.setPlan(plan_);
    if (is_readable)
        gestures_.emplace(drawn_text_, plan_, canvas_.tree());
}

std::optional<PlanPart> PlanPartEditor::selectedCallOrPart() const {
    const auto call = selectedCall();
    return call ? call : selectedPart();
}

std::optional<PlanPart> PlanPartEditor::partMeant(PlanNodeId node) const {
    const auto call = callOfNode(plan_, canvas_.tree(), node);
    return call && posh::isStep(plan_, *call) ? call : partOfNode(plan_, canvas_.tree(), node);
}

void PlanPartEditor::perform(const Result<PlanEdit>& edit) {
    if (!edit)
        emit said(QString::fromStdString(edit.error().text()), true);
    else
        emit editRequested(*edit);
}

void PlanPartEditor::perform(const std::function<Result<PlanEdit>(const std::string&, const PlanPart&)>& edit) {
    if (!gestures())
        return emit said(tr("Fix the text first; then you can edit the drawing."), true);
    const auto part = partMeant(canvas_.selected());
    if (!part)
        return emit said(tr("Select a part in the drawing first."), true);
    perform(edit(drawn_text_, *part));
}

void PlanPartEditor::addPiece(const PlanPiece& piece) {
    const PlanGestures* const can = gestures();
    if (const auto deed = can ? can->add(piece, canvas_.selected()) : std::nullopt)
        perform(deed->edit());
    else
        emit said(tr("Select a part in the drawing to which this can be added."), true);
}

void PlanPartEditor::addForm(posh::FormKind kind, const std::string& base_name) {
    const std::string free = posh::freeFormName(plan_, base_name);
    perform(posh::addForm(text_.planText(), kind, free, posh::readCallPhrase("doNothing").value()));
    if (canvas_.selected().valid())
        editInPlace(InPlace::Rename);
}

void PlanPartEditor::wrap(posh::FormKind kind) {
    if (!gestures())
        return;
    if (!canvas_.rangeEnd().valid()) {
        if (const auto part = selectedCallOrPart())
            perform(posh::wrapCall(drawn_text_, *part, kind));
        return;
    }
    const std::vector<PlanNodeId> nodes = canvas_.range();
    const auto first = partMeant(nodes.front());
    const auto last = partMeant(nodes.back());
    if (first && last)
        perform(posh::wrapParts(drawn_text_, *first, *last, kind));
}

void PlanPartEditor::inlineSelected() {
    if (const auto call = selectedCall(); call && gestures())
        perform(posh::inlineCall(drawn_text_, *call));
}

void PlanPartEditor::editInPlace(InPlace what) {
    const PlanNodeId node = canvas_.selected();
    const auto part = gestures() ? selectedPart() : std::nullopt;
    if (!node.valid() || !part)
        return;
    const posh::Plan& plan = plan_;
    const PlanNode& drawn = canvas_.tree()[node];
    QString words = drawn.name;
    if (what == InPlace::Words && part->kind == posh::PartKind::Sense)
        words += drawn.detail.isEmpty()
                     ? QString()
                     : QString::fromStdString(posh::phraseOf(*posh::senseOf(plan, *part))).mid(drawn.name.size());
    else if (what == InPlace::Rename)
        words = QString::fromStdString(posh::nameOf(plan, *part)->text);
    else if (what == InPlace::Trigger)
        words = QString::fromStdString(posh::sensesPhrase(plan, *part));
    else if (what == InPlace::Limit)
        words = QString::fromStdString(posh::limitPhrase(plan, *part));
    else if (what == InPlace::Comment)
        words = drawn.comment;
    emit drawingWanted();
    canvas_.editInPlace(node, words, static_cast<int>(what));
}

void PlanPartEditor::enterWords(PlanNodeId node, const QString& entered, int what) {
    const auto part = gestures() ? partOfNode(plan_, canvas_.tree(), node) : std::nullopt;
    if (!part)
        return;
    const std::string words = entered.trimmed().toStdString();
    const auto with = [&](auto phrase, auto edit) -> Result<PlanEdit> {
        if (!phrase)
            return tl::unexpected(phrase.error());
        return edit(drawn_text_, *part, *phrase);
    };
    switch (static_cast<InPlace>(what)) {
    case InPlace::Trigger:
        return perform(with(posh::readSensesPhrase(words), posh::setSenses));
    case InPlace::Limit:
        return perform(posh::setLimit(drawn_text_, *part, words));
    case InPlace::Comment:
        return perform(posh::setComment(drawn_text_, *part, words));
    case InPlace::Words:
        if (part->kind == posh::PartKind::Sense)
            return perform(with(posh::readSensePhrase(words), posh::replaceSense));
        if (part->kind == posh::PartKind::Action)
            return perform(with(posh::readCallPhrase(words), posh::replaceCall));
        break;
    case InPlace::Rename:
        break;
    }
    perform(posh::renamePart(drawn_text_, *part, words));
}

/// Returns the robot's description of a sense or act, or the parameters of a form of the plan, or only the name.
agent::PrimitiveDescription PlanPartEditor::describe(const posh::Call& call) const {
    const auto known = std::ranges::find(primitives_, call.name.text, &agent::PrimitiveDescription::name);
    if (known != primitives_.end())
        return *known;
    agent::PrimitiveDescription description;
    description.name = call.name.text;
    for (const posh::Form& form : plan_.forms)
        if (posh::nameOf(form).text == call.name.text)
            for (const posh::Formal& formal : posh::formalsOf(form))
                description.parameters.push_back({formal.variable.name, formal.value.value, {}, 0.0, 0.0, {}, {}});
    return description;
}

void PlanPartEditor::editValues() {
    const auto part = gestures() ? selectedPart() : std::nullopt;
    const posh::Call* const call = part ? posh::callOf(plan_, *part) : nullptr;
    if (!call)
        return;
    const posh::SenseTest* const test = posh::senseOf(plan_, *part);
    auto* const dialog = new PlanValuesDialog(describe(*call), test ? posh::Step(*test) : *call, owner_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, part = *part, is_sense = test != nullptr, text = drawn_text_] {
                if (text != text_.planText())
                    return emit said(tr("The text has changed in the meantime, so nothing was done."), true);
                perform(is_sense ? posh::replaceSense(text, part, dialog->test())
                                 : posh::replaceCall(text, part, dialog->call()));
            });
    dialog->show();
}

void PlanPartEditor::addMember(bool before) {
    const PlanGestures* const can = gestures();
    const PlanNodeId node = canvas_.selected();
    const auto part = can ? selectedPart() : std::nullopt;
    if (!part)
        return;
    const bool into = part->kind == posh::PartKind::Whole && !(selectedCall() && posh::isStep(plan_, *selectedCall()));
    const DropZone zone = into ? DropZone::Onto : before ? DropZone::Before : DropZone::After;
    const auto deed = can->drop(PlanPiece{false, QStringLiteral("doNothing")}, node, zone);
    if (!deed)
        return emit said(tr("Nothing can be added here; choose a drive, an element, a step or a form."), true);
    perform(deed->edit());
    const PlanNodeId made = canvas_.selected();
    const bool is_card = made.valid() && !canvas_.tree().children(made).empty();
    canvas_.select(is_card ? canvas_.tree().children(made).front() : made);
    editInPlace(InPlace::Words);
}

void PlanPartEditor::swap() {
    const PlanNodeId node = canvas_.selected();
    const auto part = selectedCallOrPart();
    if (!gestures() || !part)
        return;
    const bool has_first = swap_first_ && swap_text_ == drawn_text_ && *swap_first_ != *part;
    if (has_first)
        return perform(posh::swapParts(drawn_text_, *std::exchange(swap_first_, std::nullopt), *part));
    swap_first_ = part;
    swap_text_ = drawn_text_;
    emit said(tr("Now select the part to swap with %1, and press X again.").arg(canvas_.tree()[node].name), false);
}

PlanDrawingPane::PlanDrawingPane(const PlanCodeEdit& text, QWidget* editor) : QWidget(editor) {
    stale_ = makeLabel(this, "caution");
    stale_->hide();
    canvas_ = new PlanCanvas(this);
    canvas_->setMinimumSize(120, 100);
    laidOut(new QVBoxLayout(this), {}, gap::tiny, {stale_, canvas_})->setStretchFactor(canvas_, 1);
    parts_ = new PlanPartEditor(*canvas_, text, editor);
}

bool PlanDrawingPane::draw(const PlanChecker& checked) {
    const posh::Findings& findings = checked.findings();
    const bool readable = isReadable(findings);
    const bool keeps = !readable && !canvas_->tree().empty() && !parts_->drawnText().empty();
    stale_->setVisible(!readable);
    if (!readable) {
        const auto first =
            std::ranges::find_if(findings, [](const auto& finding) { return isUnreadable(finding.code); });
        stale_->setText(
            keeps ? tr("The drawing shows the plan before the error in line %1.").arg(first->at.line)
                  : tr("Only the readable parts are drawn; there is an error in line %1.").arg(first->at.line));
    }
    if (!keeps)
        parts_->draw(checked.plan(), readable);
    return !keeps;
}

} // namespace usar::widgets
