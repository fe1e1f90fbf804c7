#include "core/posh/run/program.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <string_view>
#include <tuple>

namespace usar::posh {

namespace {

/// Returns the segment of a path for a place, up to its number.
std::string_view segmentOf(PlaceKind kind) {
    constexpr std::array<std::string_view, 9> segments{
        "/DC:", "/DE:", "/C:", "/AP:", "/AD:", "/CE:", "/A:", "/A:", "/S:"};
    return segments[static_cast<std::size_t>(kind)];
}

bool isForm(PlaceKind kind) {
    return kind == PlaceKind::Competence || kind == PlaceKind::Pattern || kind == PlaceKind::Adopt;
}

// These return the fields that sameShape compares.
auto shapeOf(const Place& place) {
    return std::tie(place.kind, place.parent, place.item, place.position, place.reference);
}
auto shapeOf(const ProgramCall& call) {
    return std::tie(call.name, call.arguments);
}
auto shapeOf(const ProgramTest& test) {
    return std::tie(test.place, test.call);
}
auto shapeOf(const ProgramDrive& drive) {
    return std::tie(drive.place, drive.level, drive.trigger, drive.forms, drive.target);
}
auto shapeOf(const ProgramForm& form) {
    return std::tie(form.kind, form.place, form.parent, form.below_end, form.goal, form.items);
}
auto shapeOf(const ProgramElement& element) {
    return std::tie(element.place, element.trigger, element.target);
}

template <class Item>
bool alike(const std::vector<Item>& a, const std::vector<Item>& b) {
    return std::ranges::equal(a, b, [](const Item& x, const Item& y) { return shapeOf(x) == shapeOf(y); });
}

} // namespace

std::string pathOf(const Program& program, Index place) {
    std::vector<Index> way;
    for (Index at = place; at != nowhere; at = program.places[at].parent)
        way.push_back(at);
    std::string path = "/P:0";
    for (auto each = way.rbegin(); each != way.rend(); ++each) {
        const Index at = *each;
        const Place& here = program.places[at];
        if (isForm(here.kind))
            path.append("/A:") += std::to_string(here.reference);
        path.append(segmentOf(here.kind)) += std::to_string(here.position);
    }
    return path;
}

std::string namePathOf(const Program& program, Index place) {
    std::string path;
    for (Index at = place; at != nowhere; at = program.places[at].parent)
        path = nameOf(program, at) + (path.empty() ? "" : " ▸ ") + path;
    return path;
}

Index findPlace(const Program& program, std::string_view path, std::string_view names) {
    Index same_names = nowhere;
    for (Index place = 0; place < program.places.size(); ++place) {
        if (namePathOf(program, place) != names)
            continue;
        if (pathOf(program, place) == path)
            return place;
        if (same_names == nowhere)
            same_names = place;
    }
    return same_names;
}

bool sameShape(const Program& one, const Program& other) {
    return one.goal == other.goal && alike(one.places, other.places) && alike(one.sense_calls, other.sense_calls) &&
           alike(one.act_calls, other.act_calls) && alike(one.tests, other.tests) && one.acts == other.acts &&
           one.levels == other.levels && alike(one.drives, other.drives) && alike(one.forms, other.forms) &&
           alike(one.elements, other.elements) && one.steps == other.steps;
}

const std::string& nameOf(const Program& program, Index place) {
    return program.names[program.places[place].name];
}

const std::string& callTextAt(const Program& program, Index place) {
    static const std::string none;
    const Place& here = program.places[place];
    if (here.kind == PlaceKind::Act)
        return program.act_calls[program.acts[here.item].call].text;
    if (here.kind == PlaceKind::Sense || here.kind == PlaceKind::SenseStep)
        return program.sense_calls[program.tests[here.item].call].text;
    return none;
}

} // namespace usar::posh
