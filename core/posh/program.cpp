#include "core/posh/program.h"

#include <algorithm>
#include <string_view>

namespace usar::posh {

namespace {

std::string_view segmentOf(PlaceKind kind) {
    switch (kind) {
    case PlaceKind::Collection:
        return "/DC:";
    case PlaceKind::Drive:
        return "/DE:";
    case PlaceKind::Competence:
        return "/C:";
    case PlaceKind::Pattern:
        return "/AP:";
    case PlaceKind::Adopt:
        return "/AD:";
    case PlaceKind::Element:
        return "/CE:";
    case PlaceKind::Act:
    case PlaceKind::SenseStep:
        return "/A:";
    case PlaceKind::Sense:
        break;
    }
    return "/S:";
}

bool isForm(PlaceKind kind) {
    return kind == PlaceKind::Competence || kind == PlaceKind::Pattern || kind == PlaceKind::Adopt;
}

} // namespace

std::string pathOf(const Program& program, Index place) {
    std::vector<Index> way;
    for (Index at = place; at != nowhere; at = program.places[at].parent)
        way.push_back(at);
    std::string path = "/P:0";
    for (const Index at : std::vector<Index>(way.rbegin(), way.rend())) {
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
