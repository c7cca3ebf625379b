#pragma once

#include <vector>

#include "src/exchange/project_io/listing.hpp"
#include "src/exchange/project_io/project.hpp"

namespace rubicon::project_io {

/// Where the elements of a project stand in the file it was read from, list by list.
struct ProjectPlaces {
  std::vector<interpreter::Span> calendars, tasks, resources, assignments;
  std::vector<std::vector<interpreter::Span>> links;  ///< of each task
};

/// Brings a project as it was read into the form that the rest relies on (see Project), and lists
/// what had to be changed: an element without a number or with one already taken gets a new one
/// (I04), a reference to something that is not there is taken out (I05), so is a link twice, of a
/// task to itself, or in a ring (I06). Sorts links and exceptions; outline levels that jump by more
/// than one are drawn in.
void tidy_project(Project& project, const ProjectPlaces& places, Listing& listing);

}  // namespace rubicon::project_io
