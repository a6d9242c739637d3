// Linear search alone (001 sec. 2.2, algorithm 1): the first sample under the relief. Needs linear_bracket.glsl.

ReliefHit linear_search(ReliefRay ray) { return linear_bracket(ray, relief_linear_steps).hit; }
